// The code of a shader: what its pictures depend on.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace isomotion::shader {

// Whether it is a letter, a digit or _.
bool is_of_a_word(char c);

// Returns the text without // comments, blank lines, and spaces at the ends of lines. Shaders have
// no other comments.
std::string code_of(std::string_view text);

// The text with other words in the place of some.
std::string replaced(const std::string& text, const std::map<std::string, std::string>& words);

} // namespace isomotion::shader
