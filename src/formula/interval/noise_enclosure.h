// Bounds of gradient noise and its derivatives (graph/noise.h) over boxes.
#pragma once

#include "formula/graph/noise.h"
#include "formula/interval/interval.h"

namespace isomotion::formula {

// Boxes over up to three cells along each axis are looked at cell by cell; over others the
// bound of all space holds.
Interval noise_enclosure(Interval x, Interval y, Interval z, const NoiseOrder& order);

// A number that no derivative of this order exceeds in size, and that is a float.
double noise_bound(const NoiseOrder& order);

} // namespace isomotion::formula
