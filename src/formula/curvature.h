// Curvatures of an implicit surface, from derivatives of F. shaders/effects/curvature.glsl computes
// the same in GLSL.
#pragma once

#include <array>

namespace isomotion::formula {

struct Curvatures {
    double mean = 0;     // half of div n, n the unit normal towards F > 0: +1/r on
                         // x^2 + y^2 + z^2 - r^2, -1/r on its negative
    double gaussian = 0; // the product of the principal curvatures
};

// Curvatures of the surface of F through a point with this gradient and these second derivatives,
// in the order of hessian(). NaN where the gradient vanishes. Positive multiples of F have the same
// curvatures.
Curvatures curvatures(const std::array<double, 3>& gradient, const std::array<double, 6>& hessian);

} // namespace isomotion::formula
