#include "formula/interval/noise_enclosure.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

namespace isomotion::formula {

namespace lattice {

// Rises to 1/4 at 1/2 and falls.
template<> Interval bump(const Interval& t) {
    const auto at = [](double end) { return Interval(end) * (Interval(1) - Interval(end)); };
    const Interval first = at(t.lo), last = at(t.hi);
    const bool holds_most = t.lo <= 0.5 && t.hi >= 0.5;
    return {smaller(first.lo, last.lo), holds_most ? 0.25 : larger(first.hi, last.hi)};
}

// Rises.
template<> Interval fade(const Interval& t) {
    const auto half = [](Interval a) {
        return square(a) * a * (Interval(10) - a * (Interval(15) - Interval(6) * a));
    };
    const auto at = [&](double end) {
        return end > 0.5 ? Interval(1) - half(Interval(1) - Interval(end)) : half(end);
    };
    return {larger(at(t.lo).lo, 0.0), smaller(at(t.hi).hi, 1.0)};
}

} // namespace lattice

namespace {

// The place within the cell from `low` on.
Interval within(Interval x, double low) {
    const Interval place = x - Interval(low);
    return {std::clamp(place.lo, 0.0, 1.0), std::clamp(place.hi, 0.0, 1.0)};
}

// The corners' linear functions: noise is a mean of their values.
Interval hull_of_corners(const std::array<double, 3>& low, const std::array<Interval, 3>& place) {
    Interval hull{infinity, -infinity};
    lattice::corners(low, [&](const auto& which, const std::array<int, 3>& gradient) {
        Interval value = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Interval from_corner = place[axis] - Interval(double(which[axis]));
            if (gradient[axis] > 0) value = value + from_corner;
            if (gradient[axis] < 0) value = value - from_corner;
        }
        hull = formula::hull(hull, value);
    });
    return hull;
}

// Whatever the gradients are: two of a corner's three terms count.
double bound_of_any_cell(const NoiseOrder& order) {
    constexpr int parts = 16;
    std::array<std::vector<lattice::Weights<Interval>>, 3> weights;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < parts; ++k) {
            const Interval part(double(k) / parts, double(k + 1) / parts);
            weights[axis].emplace_back(part, order.along[axis]);
        }
    }
    double most = 0;
    for (int piece = 0; piece < parts * parts * parts; ++piece) {
        const std::array<std::size_t, 3> at{std::size_t(piece % parts),
                                            std::size_t(piece / parts % parts),
                                            std::size_t(piece / parts / parts)};
        double sum = 0;
        for (std::size_t c = 0; c < 8; ++c) {
            std::array<double, 3> terms{1, 1, 1};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto& of = weights[axis][at[axis]];
                for (std::size_t rise = 0; rise < 3; ++rise)
                    terms[rise] *= magnitude((axis == rise ? of.b : of.a)[c >> axis & 1]);
            }
            sum += terms[0] + terms[1] + terms[2] - *std::ranges::min_element(terms);
        }
        most = std::max(most, sum);
    }
    return double(std::nextafter(float(most * (1 + 0x1p-40)), HUGE_VALF));
}

} // namespace

double noise_bound(const NoiseOrder& order) {
    static std::mutex mutex;
    static std::map<int, double> known;
    const std::lock_guard lock(mutex);
    const auto [found, is_new] = known.try_emplace(order.packed());
    if (is_new) found->second = bound_of_any_cell(order);
    return found->second;
}

Interval NoiseEnclosure::operator()(Interval x, Interval y, Interval z) const {
    const lattice::Cells cells{{std::floor(x.lo), std::floor(y.lo), std::floor(z.lo)},
                               {std::floor(x.hi), std::floor(y.hi), std::floor(z.hi)}};
    const Interval anywhere{-bound_, bound_};
    if (!cells.are_few()) return anywhere;
    Interval all{infinity, -infinity};
    cells.visit([&](const std::array<double, 3>& low) {
        const std::array place{within(x, low[0]), within(y, low[1]), within(z, low[2])};
        const Interval value = lattice::in_cell<Interval>(low, place, order_);
        const bool is_value = order_.packed() == 0;
        all = hull(all, is_value ? intersect(value, hull_of_corners(low, place)) : value);
    });
    return intersect(all, anywhere);
}

} // namespace isomotion::formula
