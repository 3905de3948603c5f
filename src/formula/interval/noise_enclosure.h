// Bounds of gradient noise and its derivatives (graph/noise.h) over boxes.
#pragma once

#include "formula/graph/noise.h"
#include "formula/interval/interval.h"

namespace isomotion::formula {

// A number that no derivative of this order exceeds in size, and that is a float.
double noise_bound(const NoiseOrder& order);

class NoiseEnclosure {
public:
    explicit NoiseEnclosure(const NoiseOrder& order)
        : order_(order)
        , bound_(noise_bound(order)) {}

    // Looks at each cell of boxes over one or two cells along each axis. The bound of all space
    // holds over others.
    Interval operator()(Interval x, Interval y, Interval z) const;

private:
    NoiseOrder order_;
    double bound_;
};

} // namespace isomotion::formula
