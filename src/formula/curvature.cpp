#include "formula/curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isomotion::formula {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector scaled(const Vector& a, double by) { return {a[0] * by, a[1] * by, a[2] * by}; }

Vector multiplied(const std::array<double, 6>& h, const Vector& a) {
    return {h[0] * a[0] + h[1] * a[1] + h[2] * a[2], h[1] * a[0] + h[3] * a[1] + h[4] * a[2],
            h[2] * a[0] + h[4] * a[1] + h[5] * a[2]};
}

} // namespace

// The shape operator in a frame of the tangent plane: the invariants of Goldman, "Curvature
// formulas for implicit curves and surfaces" (2005), without the differences
// of large terms in them.
Curvatures curvatures(const std::array<double, 3>& gradient, const std::array<double, 6>& hessian) {
    const double size = std::sqrt(dot(gradient, gradient));
    if (!(size > 0)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    const Vector n = scaled(gradient, 1 / size);
    // The axis farthest from n makes the longest, and so the sharpest, cross product.
    Vector axis{};
    const auto least = std::min_element(
        n.begin(), n.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    axis[std::size_t(least - n.begin())] = 1;
    Vector u = cross(n, axis);
    u = scaled(u, 1 / std::sqrt(dot(u, u)));
    const Vector v = cross(n, u);
    const Vector hu = scaled(multiplied(hessian, u), 1 / size);
    const Vector hv = scaled(multiplied(hessian, v), 1 / size);
    const double uu = dot(u, hu), uv = dot(u, hv), vv = dot(v, hv);
    return {(uu + vv) / 2, uu * vv - uv * uv};
}

} // namespace isomotion::formula
