// Finds the name that a user meant who mistyped it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::base {

// The candidate with the smallest edit distance to `word`; empty if none is close enough for a
// typing mistake.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

} // namespace isomotion::base
