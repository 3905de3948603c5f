// F and its derivatives in space and time over boxes of (x, y, z, t), as intervals and as doubles.
//
// Parameters and array elements move by the animation's own timeline: over a span of time each is
// an enclosure of its value and of its first two derivatives. Where a track has keys these hold
// between keys: knots() are the times a box may not cross.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "formula/interval.h"
#include "scene/scene.h"

namespace isomotion::topology {

// A box of space and time, formula coordinates and seconds.
struct Box {
    std::array<formula::Interval, 4> side; // x y z t

    formula::Interval time() const { return side[3]; }
};

// What can be asked of F over a box: enclosures of all values there.
template<class T> struct Jet {
    T value{};
    std::array<T, 4> gradient{};               // F_x F_y F_z F_t
    std::array<std::array<T, 4>, 4> hessian{}; // symmetric; [3][3], F_tt, is left 0: nothing asks
};

} // namespace isomotion::topology
