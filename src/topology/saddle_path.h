// Whether the two sides of a saddle are joined elsewhere: a path, proved by intervals.
//
// At a critical point of index 1 two nappes of the solid {G < 0} meet; if a path in the solid joins
// them, the event makes or breaks a tunnel, else it joins or parts two components. At one of index
// 2 it is two nappes of what isn't solid, outside of the bounds included: a tunnel or a void. No
// path found proves nothing.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "formula/interval.h"
#include "topology/event.h"
#include "topology/frame_field.h"

namespace isomotion::topology {

using SpacePoint = std::array<double, 3>;

// G at the time of an event, formula coordinates. What is enclosed is enclosed for all times in
// Event::time. The bounds are convex and lie in `box`; both tests are proofs.
struct Moment {
    std::function<void(std::span<const SpaceBox>, std::span<ValueAndGradient>)> over;
    std::function<void(std::span<const SpaceBox>, std::span<formula::Interval>)> values;
    std::function<SpaceHessian(const SpaceBox&)> hessian;
    SpaceBox box;
    std::function<bool(const SpacePoint&)> is_inside;
    std::function<bool(const SpaceBox&)> is_outside;
};

// Searches on a grid of `cells` in the longest direction of the box. The event is of index 1 or 2.
bool sides_are_joined(const Moment& moment, const Event& event, int cells);

} // namespace isomotion::topology
