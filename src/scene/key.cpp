#include "scene/key.h"

#include <fmt/format.h>

namespace isomotion::scene::keys {

std::string Allowed::words() const {
    const bool has_least = least > -unbounded, has_most = most < unbounded;
    if (has_least && has_most && !without_least && !without_most)
        return fmt::format("from {} to {}", least, most);
    std::string words;
    if (has_least)
        words = without_least ? fmt::format("above {}", least) : fmt::format("{} or above", least);
    if (has_least && has_most) words += " and ";
    if (has_most)
        words += without_most ? fmt::format("below {}", most) : fmt::format("{} or below", most);
    return words;
}

} // namespace isomotion::scene::keys
