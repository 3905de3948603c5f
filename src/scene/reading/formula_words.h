// The names in a formula's text, before it is parsed.
#pragma once

#include <string_view>
#include <vector>

namespace isomotion::scene {

struct Word {
    std::size_t at = 0;
    std::string_view text;
};

// 2t is 2 times t, and 2e3 a number.
std::vector<Word> words_of(std::string_view formula);

// Whether a formula or an expression names t, the time, and defines nothing else of that name.
bool names_time(std::string_view formula);

} // namespace isomotion::scene
