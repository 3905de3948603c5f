// The views of a picture.
#pragma once

#include <string_view>

namespace isomotion::player {

enum class View { shaded, depth, normal, evaluations, verdicts, difference };

struct ViewName {
    View view;
    std::string_view name;
};
inline constexpr ViewName view_names[] = {
    {View::shaded, "shaded"},     {View::depth, "depth"},
    {View::normal, "normal"},     {View::evaluations, "evaluations"},
    {View::verdicts, "verdicts"}, {View::difference, "difference"},
};

constexpr std::string_view name(View view) {
    for (const ViewName& entry : view_names) {
        if (entry.view == view) return entry.name;
    }
    return "?";
}

} // namespace isomotion::player
