// The part of a shader file that a text with some features has.
//
// Files ask for features by #ifdef, #ifndef, #if, #elif, #else and #endif, with conditions of
// names, whole numbers, comparisons, defined(), !, && and ||. This answers them, so that drivers
// and readers get no more than what is active. What asks for macros of the compiler, GL_... and
// __VERSION__, stays for the compiler.
#pragma once

#include <string>
#include <string_view>

#include "shader/feature.h"

namespace isomotion::shader {

// Throws base::InputError, "shaders/file:line: ...", if a condition has other names or ends without
// having begun.
std::string active_lines(std::string_view file, std::string_view text, Features& features);

} // namespace isomotion::shader
