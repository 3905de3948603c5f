// Points of space and symmetric matrices, in doubles.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "topology/field/space_box.h"

namespace isomotion::topology {

using SpacePoint = std::array<double, 3>;
using SpaceMatrix = std::array<std::array<double, 3>, 3>; // symmetric

inline SpacePoint along(const SpacePoint& p, double step, const SpacePoint& direction) {
    return {p[0] + step * direction[0], p[1] + step * direction[1], p[2] + step * direction[2]};
}
inline SpacePoint difference(const SpacePoint& a, const SpacePoint& b) { return along(a, -1, b); }
inline double dot(const SpacePoint& a, const SpacePoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const SpacePoint& v) { return std::hypot(v[0], v[1], v[2]); }
inline double distance(const SpacePoint& a, const SpacePoint& b) {
    return length(difference(a, b));
}

inline SpaceBox point_box(const SpacePoint& p) { return {p[0], p[1], p[2]}; }
inline SpacePoint middle(const SpaceBox& box) { return {mid(box[0]), mid(box[1]), mid(box[2])}; }

// The numbers of positive and of negative eigenvalues.
struct Inertia {
    int positive = 0, negative = 0;
};
Inertia inertia(const SpaceMatrix& a);

// a^-1 b; empty if a is singular.
std::optional<SpacePoint> solve(const SpaceMatrix& a, const SpacePoint& b);

// The unit eigenvector of the least eigenvalue. Axes that are not free are excluded.
SpacePoint least_direction(SpaceMatrix a, const std::array<bool, 3>& free = {true, true, true});

} // namespace isomotion::topology
