// Whether a driver's doubles can be trusted with bounds.
//
// GLSL only promises that doubles are no less precise than floats. shaders/interval/float64.glsl
// counts on sums and products rounded to nearest, on quotients and roots within 2^-50, and on exact
// comparisons, conversions and literals.
#pragma once

#include <string>

namespace isomotion::render {

// Measures some thousand operands in the current context, of OpenGL 4.0, nasty ones first, against
// the processor. The first that comes out otherwise, such as "a + b at 1 and 0x1p-53: 1, not ...",
// or empty if none does.
// Takes two texture units.
std::string fault_of_doubles(int first_unit = 0);

// Whether there is none, and the current context has doubles.
bool can_trust_doubles(int first_unit);

} // namespace isomotion::render
