// Polynomials of POV-Ray: poly, cubic, quartic and quadric.
#pragma once

#include <string>
#include <string_view>

#include "scene/reading/pov_values.h"

namespace isomotion::scene {

// Coefficients between < and >, in POV-Ray's order: x^n, x^(n-1) y, x^(n-1) z, x^(n-1) ... 1.
std::string pov_polynomial(PovCursor& at, PovValues& values, int order, std::string_view key);

// <A, B, C>, <D, E, F>, <G, H, I>, J: of x^2, y^2, z^2, xy, xz, yz, x, y, z and 1.
std::string pov_quadric(PovCursor& at, PovValues& values);

} // namespace isomotion::scene
