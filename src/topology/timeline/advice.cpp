#include "topology/timeline/advice.h"

#include <algorithm>
#include <string_view>

namespace isomotion::topology {
namespace {

struct Advice {
    std::string_view why; // of an unresolved place
    const char* words;
};

constexpr Advice of_places[] = {
    {unresolved::kink, "write smoothmin(a, b, k) for min(a, b), -smoothmin(-a, -b, k) for max(a, "
                       "b) and sqrt(q + k^2) "
                       "for sqrt(q) or abs: events of smooth surfaces are proved"},
    {unresolved::kinks_meet, "where faces meet that are parallel, or more than three at a point, "
                             "turn or move one body by a "
                             "little: bodies that touch at one point are proved; or write "
                             "smoothmin(a, b, k) for min(a, b)"},
    {unresolved::degenerate,
     "where events coincide, by symmetry or because the surface is singular along a curve, change "
     "a parameter by a little; --frames A-B without that moment can be complete"},
    {unresolved::index,
     "change a parameter by a little: an event is proved where the surface is not singular along a "
     "curve"},
    {unresolved::on_edge, "take bounds that are a little larger or smaller"},
    {unresolved::touches_edge, "take bounds that are a little larger or smaller"},
    {unresolved::rule_changes,
     "let --frames A-B begin or end beside that moment, or put no key there"},
    {unresolved::rests,
     "let the motion pass that moment without resting: another key, or ease = \"linear\""},
    {unresolved::turns,
     "let the motion pass that moment without turning, or --frames A-B end before it"},
    {unresolved::jumps,
     "search the spans before and after the jump with --frames A-B, each for itself"},
    {unresolved::no_bounds, "give bounds that hold something at all times"},
};

} // namespace

std::vector<std::string> advice(const Timeline& timeline) {
    std::vector<std::string> found;
    const auto add = [&](std::string_view words) {
        if (std::ranges::find(found, words) == found.end()) found.emplace_back(words);
    };
    for (const Advice& one : of_places) {
        const bool is_met = std::ranges::any_of(
            timeline.unresolved, [&](const Unresolved& place) { return place.why == one.why; });
        if (is_met) add(one.words);
    }
    const bool has_unknown = std::ranges::any_of(
        timeline.events, [](const Event& event) { return event.kind == Kind::unknown; });
    if (has_unknown) {
        add("a shorter span, --frames A-B, from a little before to a little after an event of "
            "unknown "
            "kind may tell its kind");
    }
    // What is unresolved says more.
    if (!timeline.unresolved.empty()) return found;
    if (!timeline.start || !timeline.end) {
        add("begin or end at another frame, --frames A-B: the first and the last are proved where "
            "the surface has no singular point and no kink");
    } else if (!timeline.start_is_proved || !timeline.end_is_proved) {
        add("--certify full proves what signs on a grid show");
    }
    return found;
}

} // namespace isomotion::topology
