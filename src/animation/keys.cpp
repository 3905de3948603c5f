#include "animation/keys.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isomotion::animation {
double Keys::velocity(std::size_t k) const {
    const Key& before = keys[k == 0 ? 0 : k - 1];
    const Key& after = keys[std::min(k + 1, keys.size() - 1)];
    return (after.value - before.value) / (after.time - before.time);
}

double Keys::at(double time) const {
    assert(!keys.empty());
    if (time <= keys.front().time) return keys.front().value;
    if (time >= keys.back().time) return keys.back().value;
    const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                        [](double t, const Key& key) { return t < key.time; });
    const auto k = std::size_t(after - keys.begin()) - 1;
    const Key &a = keys[k], &b = keys[k + 1];
    const double length = b.time - a.time;
    const double u = (time - a.time) / length;
    switch (ease) {
    case Ease::linear:
        return std::lerp(a.value, b.value, u);
    case Ease::smooth:
        return std::lerp(a.value, b.value, u * u * (3 - 2 * u));
    case Ease::hold:
        return a.value;
    case Ease::cubic: {
        const double va = velocity(k) * length, vb = velocity(k + 1) * length;
        const double v = 1 - u;
        return a.value * (1 + 2 * u) * v * v + va * u * v * v + b.value * u * u * (3 - 2 * u) -
               vb * u * u * v;
    }
    }
    return a.value;
}

} // namespace isomotion::animation
