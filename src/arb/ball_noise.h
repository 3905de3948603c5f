// Gradient noise and its derivatives (formula/graph/noise.h) in ball arithmetic.
#pragma once

#include <array>

#include "arb/ball.h"
#include "formula/graph/noise.h"

namespace isomotion::ball {

// The hull of the polynomials of the cells that the balls meet, or the bound of all space where
// these are many. Indeterminate where an operand is without bounds.
Ball noise(const std::array<Ball, 3>& place, const formula::NoiseOrder& order, slong precision);

} // namespace isomotion::ball
