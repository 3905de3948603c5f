#include "scene/reading/read_keys.h"

#include <algorithm>

#include "base/nearest_name.h"

namespace isomotion::scene {

std::optional<std::size_t> read_word(Section& section, const char* key,
                                     const std::vector<std::string_view>& words) {
    const auto text = section.text(key);
    if (!text) return std::nullopt;
    const auto found = std::ranges::find(words, *text);
    if (found != words.end()) return std::size_t(found - words.begin());
    const std::string near =
        base::nearest_name(*text, std::vector<std::string>(words.begin(), words.end()));
    section.tell(key, fmt::format("there is no {} '{}'; {}known: {}", key, *text,
                                  near.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                                  fmt::join(words, ", ")));
    return std::nullopt;
}

} // namespace isomotion::scene
