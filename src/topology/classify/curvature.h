// How a function bends in a direction.
#pragma once

#include "topology/field/space_box.h"

namespace isomotion::topology {

// d^T H d.
inline formula::Interval curvature(const SpaceHessian& h, const SpaceBox& d) {
    formula::Interval sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum = sum + h[i][i] * square(d[i]);
        for (std::size_t j = i + 1; j < 3; ++j)
            sum = sum + formula::Interval(2) * h[i][j] * (d[i] * d[j]);
    }
    return sum;
}

} // namespace isomotion::topology
