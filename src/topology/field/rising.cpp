#include "topology/field/rising.h"

#include <algorithm>
#include <cmath>

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr int most_steps = 40;

using Axes = std::span<const std::size_t>;

double product(const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t k = 0; k < most_variables; ++k) sum += a[k] * b[k];
    return sum;
}

// The point of the hull of some points that is nearest to 0, nearly.
Point nearest_to_0(std::span<const Point> points) {
    Point at = points[0];
    for (int step = 0; step < most_steps; ++step) {
        const auto lowest =
            std::ranges::min_element(points, {}, [&](const Point& p) { return product(p, at); });
        Point to{};
        for (std::size_t k = 0; k < most_variables; ++k) to[k] = (*lowest)[k] - at[k];
        const double length = product(to, to);
        if (!(length > 0)) break;
        const double part = std::clamp(-product(at, to) / length, 0.0, 1.0);
        if (part == 0) break;
        for (std::size_t k = 0; k < most_variables; ++k) at[k] += part * to[k];
    }
    return at;
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
