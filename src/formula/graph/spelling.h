// The names that functions, constants and coordinates have elsewhere.
#pragma once

#include <string>
#include <string_view>

namespace isomotion::formula {

// The name in a formula of what `word` means in another notation: sin for Sin, x for X, pi for Pi,
// asinh for arsinh, tan for tg, if for where. The word itself if it has no such meaning, or more
// than one: sqr is a square in some languages and a root in others.
std::string plain_spelling(std::string_view word);

// Why a word is not read, and what to write instead: for Piecewise, vec3, sqr. Empty if nothing is
// known of it.
std::string_view advice_for(std::string_view word);

} // namespace isomotion::formula
