// What GLSL made from a formula may consist of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::fuzz {

// Throws Violation unless the text is words of the generator's own, numbers that are finite floats,
// and operators: no name of a scene, no comment, no preprocessor.
void check_generated(std::string_view glsl);

// The text without its comments; an unfinished one ends it.
std::string without_comments(std::string_view glsl);

// The comments alone, each without its marks.
std::vector<std::string> comments(std::string_view glsl);

} // namespace isomotion::fuzz
