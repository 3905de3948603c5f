#include "topology/search/rising.h"

#include <algorithm>
#include <cmath>

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr int most_steps = 40;

double product(const Point& a, const Point& b, std::size_t n) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += a[k] * b[k];
    return sum;
}

// The point of the hull of some points that is nearest to 0, nearly.
Point nearest_to_0(std::span<const Point> points, std::size_t n) {
    Point at = points[0];
    for (int step = 0; step < most_steps; ++step) {
        const auto lowest = std::ranges::min_element(
            points, {}, [&](const Point& p) { return product(p, at, n); });
        Point to{};
        for (std::size_t k = 0; k < n; ++k) to[k] = (*lowest)[k] - at[k];
        const double length = product(to, to, n);
        if (!(length > 0)) break;
        const double part = std::clamp(-product(at, to, n) / length, 0.0, 1.0);
        if (part == 0) break;
        for (std::size_t k = 0; k < n; ++k) at[k] += part * to[k];
    }
    return at;
}

bool rise_along(const Point& d, std::span<const Box> gradients, std::size_t n) {
    return std::ranges::all_of(gradients, [&](const Box& g) {
        Interval rise = 0;
        for (std::size_t k = 0; k < n; ++k) rise = rise + Interval(d[k]) * g[k];
        return rise.lo > 0;
    });
}

} // namespace

bool rise_together(std::span<const Box> gradients, std::size_t n) {
    if (gradients.empty() || n == 0) return false;
    std::vector<Point> middles;
    for (const Box& g : gradients) {
        Point& middle = middles.emplace_back();
        for (std::size_t k = 0; k < n; ++k) {
            if (std::isinf(magnitude(g[k]))) return false;
            middle[k] = mid(g[k]);
        }
    }
    return rise_along(nearest_to_0(middles, n), gradients, n);
}

} // namespace isomotion::topology
