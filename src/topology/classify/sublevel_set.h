// The side of the surface whose parts an event joins or separates.
#pragma once

#include <span>
#include <vector>

#include "topology/classify/field_snapshot.h"

namespace isomotion::topology {

// The region whose parts are to be joined: H = G < 0 within the bounds; or H = -G < 0 together with
// the exterior of the bounds.
class SublevelSet {
public:
    SublevelSet(const FieldSnapshot& snapshot, bool is_solid)
        : snapshot_(snapshot)
        , is_solid_(is_solid) {}

    bool is_solid() const { return is_solid_; }
    const SpaceBox& box() const { return snapshot_.box; }
    const EnclosedBounds& bounds() const { return snapshot_.bounds; }
    // False if a coordinate is provably off both walls perpendicular to it.
    bool may_be_on_wall(std::size_t axis, formula::Interval coordinate) const {
        return !is_empty(intersect(coordinate, bounds().low[axis])) ||
               !is_empty(intersect(coordinate, bounds().high[axis]));
    }

    std::vector<ValueAndGradient> over(std::span<const SpaceBox> boxes) const;
    // Narrows such enclosures of H by its second derivatives, which takes longer.
    void tighten(std::span<const SpaceBox> boxes, std::span<ValueAndGradient> h) const;
    std::vector<formula::Interval> values(std::span<const SpaceBox> boxes) const;
    SpaceHessian hessian(const SpaceBox& box) const;

    // Whether a point may be a corner of a path. Between two such points the path stays inside of
    // the bounds, since these are convex.
    bool may_hold(const SpacePoint& p) const { return !is_solid_ || snapshot_.is_inside(p); }
    bool is_inside(const SpacePoint& p) const { return snapshot_.is_inside(p); }
    bool is_outside(const SpaceBox& box) const { return !is_solid_ && snapshot_.is_outside(box); }
    // Whether the whole box is inside the bounds, which are convex.
    bool is_all_inside(const SpaceBox& box) const;
    bool has_corner_outside(const SpaceBox& box) const;
    bool is_all_outside(const SpaceBox& box) const { return snapshot_.is_outside(box); }

private:
    // From G to H, or back.
    void of_region(std::span<ValueAndGradient> enclosures) const;

    const FieldSnapshot& snapshot_;
    bool is_solid_;
};

} // namespace isomotion::topology
