// Whether the two sides of a saddle are joined elsewhere: a path, proved by intervals.
//
// At a critical point of index 1 two nappes of the solid {G < 0} meet; if a path in the solid joins
// them, the event makes or breaks a tunnel, else it joins or parts two components. At one of index
// 2 it is two nappes of what isn't solid, outside of the bounds included: a tunnel or a void.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/event.h"
#include "topology/space_point.h"

namespace isomotion::topology {

// G at the time of an event, formula coordinates. What is enclosed is enclosed for all times in
// Event::time. The bounds are convex and lie in `box`; both tests are proofs.
struct Moment {
    std::function<void(std::span<const SpaceBox>, std::span<ValueAndGradient>)> over;
    std::function<void(std::span<const SpaceBox>, std::span<formula::Interval>)> values;
    std::function<SpaceHessian(const SpaceBox&)> hessian;
    SpaceBox box;
    SpaceBox low, high; // the walls of the bounds, or of the box around them
    std::function<bool(const SpacePoint&)> is_inside;
    std::function<bool(const SpaceBox&)> is_outside;
};

// The region whose parts are to be joined: H < 0 in the bounds, H being G; or H = -G < 0 and all
// that is outside of them.
class Region {
public:
    Region(const Moment& moment, bool is_solid)
        : moment_(moment)
        , is_solid_(is_solid) {}

    bool is_solid() const { return is_solid_; }
    const SpaceBox& box() const { return moment_.box; }
    // False where a coordinate is provably off both walls across it.
    bool may_be_on_wall(std::size_t axis, formula::Interval coordinate) const {
        return !is_empty(intersect(coordinate, moment_.low[axis])) ||
               !is_empty(intersect(coordinate, moment_.high[axis]));
    }

    std::vector<ValueAndGradient> over(std::span<const SpaceBox> boxes) const;
    std::vector<formula::Interval> values(std::span<const SpaceBox> boxes) const;
    SpaceHessian hessian(const SpaceBox& box) const;

    // Points that a path may have for corners. Between two of them it is inside of the bounds, for
    // these are convex.
    bool may_hold(const SpacePoint& p) const { return !is_solid_ || moment_.is_inside(p); }
    bool is_outside(const SpaceBox& box) const { return !is_solid_ && moment_.is_outside(box); }

private:
    const Moment& moment_;
    bool is_solid_;
};

// Points on both sides of an event of index 1 or 2, each joined to it in the region.
std::optional<std::array<SpacePoint, 2>> both_sides(const Region& region, const Event& event);

// Whether a path in the region joins the first corner to the last; it need not be this polyline,
// but is close to it. `failed` is the corner before which the proof failed.
bool is_path(const Region& region, std::span<const SpacePoint> corners,
             std::size_t* failed = nullptr);

} // namespace isomotion::topology
