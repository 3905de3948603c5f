// Boxes of space, and a field's enclosures over one.
#pragma once

#include <algorithm>
#include <array>

#include "formula/interval/interval.h"

namespace isomotion::topology {

using SpaceBox = std::array<formula::Interval, 3>;
using SpaceHessian = std::array<std::array<formula::Interval, 3>, 3>;

struct ValueAndGradient {
    formula::Interval value;
    std::array<formula::Interval, 3> gradient;
};

inline SpaceBox hull_of(const SpaceBox& a, const SpaceBox& b) {
    return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}
inline double longest_side(const SpaceBox& box) {
    double longest = 0;
    for (const formula::Interval& side : box) longest = std::max(longest, side.hi - side.lo);
    return longest;
}

} // namespace isomotion::topology
