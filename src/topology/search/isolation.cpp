#include "topology/search/isolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "topology/search/critical_system.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// So near to the limit of Newton's method the root is sought first: a part of the domain.
constexpr double little_part = 1e-9;

// The limit of Newton's method, or where it is after some steps. Empty if it leaves: the root that
// it may find is not this box's.
std::optional<Point> limit(const Box& domain, Numbers& numbers, const Box& box, std::size_t n) {
    Point x{};
    for (std::size_t k = 0; k < n; ++k) x[k] = mid(box[k]);
    bool converges = false;
    for (int k = 0; k < 20 && !converges; ++k) {
        const auto step = newton_step(numbers.jet(x), n);
        if (!step) return std::nullopt;
        const auto& by = *step;
        converges = true;
        for (std::size_t i = 0; i < n; ++i) {
            x[i] -= by[i];
            const double reach = box[i].hi - box[i].lo, whole = domain[i].hi - domain[i].lo;
            if (!(std::abs(x[i] - mid(box[i])) <= 2 * reach + 1e-9 * whole)) return std::nullopt;
            const double scale = std::max(std::abs(x[i]), magnitude(domain[i]));
            converges &= std::abs(by[i]) <= 1e-14 * scale;
        }
    }
    return x;
}

} // namespace

std::optional<CriticalPoint> isolate(const MovingField& field, Enclosures& enclosures,
                                     Numbers& numbers, const Box& box) {
    const auto n = std::size_t(field.variables());
    const auto x = limit(field.domain(), numbers, box, n);
    if (!x) return std::nullopt;
    Box alone{}, about{};
    for (std::size_t k = 0; k < n; ++k) {
        const double margin = 0.1 * (box[k].hi - box[k].lo) +
                              1e-13 * std::max(std::abs((*x)[k]), magnitude(field.domain()[k]));
        alone[k] = {std::min(box[k].lo, (*x)[k]) - margin, std::max(box[k].hi, (*x)[k]) + margin};
        const double whole = field.domain()[k].hi - field.domain()[k].lo;
        const double little = std::min(margin / 2, little_part * whole);
        about[k] = {(*x)[k] - little, (*x)[k] + little};
    }
    std::vector<Jet<Interval>> jets;
    const auto contract = [&](const Box& in) -> std::optional<Krawczyk> {
        Point m = *x;
        for (std::size_t k = 0; k < n; ++k) m[k] = std::clamp(m[k], in[k].lo, in[k].hi);
        // Together: all elements of sums are gone through once.
        enclosures.jets(enclosures.all(), std::array{in, at_point(m)}, jets);
        const IntervalMatrix slopes = jacobian(jets[0], n);
        const auto y = middle_inverse(slopes, int(n));
        if (!y) return std::nullopt;
        return krawczyk(in, m, residual(jets[1], n), slopes, *y, int(n));
    };
    const auto first = contract(alone);
    if (!first || !first->is_inside) return std::nullopt;
    CriticalPoint point{first->image, alone, {}};
    // A wide box shrinks slowly. A box within it that holds a root, too, holds the same one.
    if (const auto narrow = contract(about); narrow && narrow->is_inside)
        point.where = narrow->image;
    // A wide box may shrink slowly at first.
    constexpr double narrow = 1e-9, while_narrow = 0.8, while_wide = 0.99;
    for (int k = 0; k < 100; ++k) {
        const auto next = contract(point.where);
        if (!next) break;
        bool shrinks = false;
        for (std::size_t i = 0; i < n; ++i) {
            const Interval both = intersect(point.where[i], next->image[i]);
            const double before = point.where[i].hi - point.where[i].lo;
            const double whole = field.domain()[i].hi - field.domain()[i].lo;
            shrinks |=
                both.hi - both.lo < (before > narrow * whole ? while_wide : while_narrow) * before;
            point.where[i] = both;
        }
        if (!shrinks) break;
    }
    point.jet = enclosures.jet(point.where);
    return point;
}

} // namespace isomotion::topology
