// How long shaders become in a driver.
#pragma once

#include <string_view>

#include "synthesis/pass.h"

namespace isomotion::synthesis {

// Operators in a shader's text once the body of every function stands where it is called, as
// drivers put it before they compile; of overloads the mean, of the field's bounds the half and of
// waves two fifths, which fits the times of Mesa. Functions begin and end in the first column, as
// ours do.
double inlined_size(std::string_view shader);

// The size of all passes that are compiled before the first frame, together.
double inlined_size(const Passes& passes);

// What Mesa's llvmpipe compiles in 4 to 10 s of one core and 0.9 GB: its time grows with the
// square. ISOMOTION_LARGEST_SHADERS in the environment takes its place.
double largest_shaders();

// Throws std::length_error for more.
void check_size(const Passes& passes);

} // namespace isomotion::synthesis
