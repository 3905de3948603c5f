// Estimates the size of shaders after inlining in a driver.
#pragma once

#include <string_view>

#include "shader/pass.h"

namespace isomotion::shader {

// The number of operators in a shader's text once the body of every function is inlined at its
// calls, as drivers do before they compile. Overloads count as their mean, the field's bounds by
// half and waves by two fifths, and each number and parameter of the field as one and a half, which
// fits the compile times of Mesa. Functions must begin and end in the first column, as ours do.
double inlined_size(std::string_view shader);

// The total size of all passes that are compiled before the first frame.
double inlined_size(const Passes& passes);

// The size that Mesa's llvmpipe compiles in 4 to 10 s of one core; its time grows with the square
// of the size. Longer formulas are run as tapes (tape_text.h). ISOMOTION_LARGEST_SHADERS in the
// environment replaces it.
double largest_shaders();

// Throws std::length_error if the passes are larger.
void check_size(const Passes& passes);

} // namespace isomotion::shader
