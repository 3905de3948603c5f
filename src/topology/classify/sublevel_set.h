// The side of the surface whose parts an event joins or parts.
#pragma once

#include <span>
#include <vector>

#include "topology/classify/field_snapshot.h"

namespace isomotion::topology {

// The region whose parts are to be joined: H < 0 in the bounds, H being G; or H = -G < 0 and all
// that is outside of them.
class SublevelSet {
public:
    SublevelSet(const FieldSnapshot& snapshot, bool is_solid)
        : snapshot_(snapshot)
        , is_solid_(is_solid) {}

    bool is_solid() const { return is_solid_; }
    const SpaceBox& box() const { return snapshot_.box; }
    // False where a coordinate is provably off both walls across it.
    bool may_be_on_wall(std::size_t axis, formula::Interval coordinate) const {
        return !is_empty(intersect(coordinate, snapshot_.low[axis])) ||
               !is_empty(intersect(coordinate, snapshot_.high[axis]));
    }

    std::vector<ValueAndGradient> over(std::span<const SpaceBox> boxes) const;
    std::vector<formula::Interval> values(std::span<const SpaceBox> boxes) const;
    SpaceHessian hessian(const SpaceBox& box) const;

    // Points that a path may have for corners. Between two of them it is inside of the bounds, for
    // these are convex.
    bool may_hold(const SpacePoint& p) const { return !is_solid_ || snapshot_.is_inside(p); }
    bool is_outside(const SpaceBox& box) const { return !is_solid_ && snapshot_.is_outside(box); }
    // Whether all is inside the bounds, which are convex.
    bool is_all_inside(const SpaceBox& box) const;
    bool is_all_outside(const SpaceBox& box) const { return snapshot_.is_outside(box); }

private:
    const FieldSnapshot& snapshot_;
    bool is_solid_;
};

} // namespace isomotion::topology
