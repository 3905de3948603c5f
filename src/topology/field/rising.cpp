#include "topology/field/rising.h"

#include <algorithm>
#include <cmath>

namespace isomotion::topology {
namespace {

using formula::Interval;

// With more points than these not all triangles are looked at.
constexpr std::size_t few = 16;
constexpr int most_steps = 100;

using Axes = std::span<const std::size_t>;

double product(const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t k = 0; k < most_variables; ++k) sum += a[k] * b[k];
    return sum;
}

Point mix(const Point& a, double part, const Point& b) { // a + part (b - a)
    Point mixed{};
    for (std::size_t k = 0; k < most_variables; ++k) mixed[k] = a[k] + part * (b[k] - a[k]);
    return mixed;
}

// The point of a segment that is nearest to 0.
Point nearest_of_segment(const Point& a, const Point& b) {
    Point along{};
    for (std::size_t k = 0; k < most_variables; ++k) along[k] = b[k] - a[k];
    const double length = product(along, along);
    return length > 0 ? mix(a, std::clamp(-product(a, along) / length, 0.0, 1.0), b) : a;
}

// ... of a triangle's plane, where it is in the triangle: a + u (b - a) + v (c - a).
std::optional<Point> nearest_of_triangle(const Point& a, const Point& b, const Point& c) {
    Point e{}, f{};
    for (std::size_t k = 0; k < most_variables; ++k) {
        e[k] = b[k] - a[k];
        f[k] = c[k] - a[k];
    }
    const double ee = product(e, e), ef = product(e, f), ff = product(f, f);
    const double ae = -product(a, e), af = -product(a, f), det = ee * ff - ef * ef;
    if (!(det > 0)) return std::nullopt;
    const double u = (ae * ff - af * ef) / det, v = (af * ee - ae * ef) / det;
    if (!(u > 0 && v > 0 && u + v < 1)) return std::nullopt;
    Point at{};
    for (std::size_t k = 0; k < most_variables; ++k) at[k] = a[k] + u * e[k] + v * f[k];
    return at;
}

Point nearest_by_steps(std::span<const Point> points) {
    Point at = points[0];
    for (int step = 0; step < most_steps; ++step) {
        const auto lowest =
            std::ranges::min_element(points, {}, [&](const Point& p) { return product(p, at); });
        at = nearest_of_segment(at, *lowest);
    }
    return at;
}

// The point of the hull of some points in space that is nearest to 0; if that is outside, it is on
// a point, a segment or a triangle of them. For many points it is nearly that (Gilbert 1966).
Point nearest_to_0(std::span<const Point> points) {
    const std::size_t n = points.size();
    if (n > few) return nearest_by_steps(points);
    Point nearest = points[0];
    const auto take = [&](const Point& p) {
        if (product(p, p) < product(nearest, nearest)) nearest = p;
    };
    for (std::size_t i = 0; i < n; ++i) {
        take(points[i]);
        for (std::size_t j = i + 1; j < n; ++j) {
            take(nearest_of_segment(points[i], points[j]));
            for (std::size_t k = j + 1; k < n; ++k) {
                if (const auto p = nearest_of_triangle(points[i], points[j], points[k])) take(*p);
            }
        }
    }
    return nearest;
}

bool rise_along(const Point& d, std::span<const Box> gradients, Axes free) {
    return std::ranges::all_of(gradients, [&](const Box& g) {
        Interval rise = 0;
        for (const std::size_t k : free) {
            if (d[k] != 0) rise = rise + Interval(d[k]) * g[k];
        }
        return rise.lo > 0;
    });
}

} // namespace

std::optional<Point> rising_direction(std::span<const Box> gradients, Axes free) {
    if (gradients.empty() || free.empty()) return std::nullopt;
    std::vector<Point> middles;
    for (const Box& g : gradients) {
        Point& middle = middles.emplace_back();
        for (const std::size_t k : free) middle[k] = std::isinf(magnitude(g[k])) ? 0 : mid(g[k]);
    }
    const Point d = nearest_to_0(middles);
    if (rise_along(d, gradients, free)) return d;
    // Along an axis nothing is asked of the other components.
    for (const std::size_t k : free) {
        for (const double sign : {-1.0, 1.0}) {
            Point axis{};
            axis[k] = sign;
            if (rise_along(axis, gradients, free)) return axis;
        }
    }
    return std::nullopt;
}

} // namespace isomotion::topology
