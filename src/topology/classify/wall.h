// The part of the bounds that an event lies on, and how H bends along it.
//
// Inside of the bounds there is none; on a box it is one face or more, on a sphere the sphere. Let
// g be H along a straight line of a face, or along a great circle of the sphere. Its second
// derivative is t^T B t, with t the unit vector along the line: B is H'' on a face and H'' - (grad
// H . m / r^2) I on a sphere of radius r, with m from the centre to the place.
#pragma once

#include <array>
#include <optional>

#include "topology/classify/sublevel_set.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

class Wall {
public:
    // None if walls cannot be told apart at the event.
    static std::optional<Wall> at(const SublevelSet& region, const Event& event);

    bool is_sphere() const { return is_sphere_; }
    // The axes along the faces; all of them for a sphere.
    const std::array<bool, 3>& free() const { return free_; }
    // Out of the bounds at the event, where it lies on one face or on the sphere.
    const SpaceBox& outwards() const { return outwards_; }

    // B over a box, with `more` times the square of each unit vector across the wall. On a face all
    // else that B has across the wall is left out.
    SpaceHessian bend(const SublevelSet& region, const SpaceBox& box, double more = 0) const;
    // Whether H rises into the bounds from all walls, over a box.
    bool rises_inwards(const SublevelSet& region, const SpaceBox& box) const;
    // The unit vector along the wall in whose direction H bends down most, in doubles.
    SpacePoint down(const SublevelSet& region, const SpaceBox& where) const;
    // From the centre of a sphere to the points of a box.
    static SpaceBox from_centre(const SublevelSet& region, const SpaceBox& box);
    // A vector less what of it is across the wall at the event.
    SpaceBox along(const SpacePoint& direction) const;

private:
    bool is_sphere_ = false;
    std::array<bool, 3> free_{true, true, true};
    std::array<int, 3> inwards_{}; // along each axis that is not free
    SpaceBox outwards_{};
};

} // namespace isomotion::topology
