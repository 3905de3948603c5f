// Coordinates that move with a surface. A box that moves along holds the same part of the surface
// for longer, so a search takes fewer boxes.
//
// x = p (1 + (t - from) growth) + (t - from) by, for points p that rest in the new coordinates. At
// each time this is a similarity. So a surface has the same critical points with the same index in
// both coordinates, and where dF/dx = 0, dF/dt is the same in both.
#pragma once

#include <array>

#include "formula/interval/interval.h"

namespace isomotion::topology {

struct ComovingFrame {
    double from = 0; // a time; there p equals x
    std::array<double, 3> by{};
    double growth = 0;

    bool rests() const { return by == std::array<double, 3>{} && growth == 0; }
    // Converts coordinate k from one frame to the other.
    template<class T> T x(std::size_t k, T p, T t) const {
        const T since = t - T(from);
        return p * (T(1.0) + since * T(growth)) + since * T(by[k]);
    }
    template<class T> T p(std::size_t k, T x, T t) const {
        const T since = t - T(from);
        return (x - since * T(by[k])) / (T(1.0) + since * T(growth));
    }
};

} // namespace isomotion::topology
