// What a user meant who mistyped a name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::base {

// The candidate with the smallest edit distance to `word`, or empty if none is near enough to be a
// slip of the finger.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

} // namespace isomotion::base
