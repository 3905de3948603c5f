#include "topology/field/easing.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

using formula::Interval;

Interval smoothstep(double u) {
    const Interval at(u);
    return at * at * (Interval(3) - Interval(2) * at);
}

// Doubles beside which the way is made, found by halving: `is_before` holds of all below.
template<class Test> Interval narrowed(Test&& is_before) {
    Interval found(0, 1);
    while (true) {
        const double middle = mid(found);
        if (!(found.lo < middle && middle < found.hi)) return found;
        (is_before(middle) ? found.lo : found.hi) = middle;
    }
}

} // namespace

Interval Easing::way(Interval time) const {
    const Interval length = Interval(to) - Interval(from);
    const Interval u = (time - Interval(from)) / length;
    const double first = std::clamp(u.lo, 0.0, 1.0), last = std::clamp(u.hi, 0.0, 1.0);
    return {std::max(smoothstep(first).lo, 0.0), std::min(smoothstep(last).hi, 1.0)};
}

Interval Easing::time(Interval way) const {
    double first = 0, last = 1;
    if (way.lo > 0) first = narrowed([&](double u) { return smoothstep(u).hi <= way.lo; }).lo;
    if (way.hi < 1) last = narrowed([&](double u) { return smoothstep(u).lo < way.hi; }).hi;
    const Interval time = Interval(from) + (Interval(to) - Interval(from)) * Interval(first, last);
    return {std::clamp(time.lo, from, to), std::clamp(time.hi, from, to)};
}

} // namespace isomotion::topology
