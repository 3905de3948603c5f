// Tests whether a driver's doubles are accurate enough for bounds.
//
// GLSL only promises that doubles are at least as precise as floats. shaders/interval/float64.glsl
// relies on sums and products rounded to nearest, on quotients and roots within 2^-50, and on exact
// comparisons, conversions and literals.
#pragma once

#include <string>

namespace isomotion::render {

// Compares some thousand operations in the current context, of OpenGL 4.0, with the processor, hard
// operands first. Returns the first that differs, such as "a + b at 1 and 0x1p-53: 1, not ...", or
// an empty text. Uses two texture units.
std::string fault_of_doubles(int first_unit = 0);

// Whether there is no such fault, and the current context has doubles.
bool can_trust_doubles(int first_unit);

} // namespace isomotion::render
