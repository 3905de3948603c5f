// What separates the two sides of an event close to it, where boxes can't tell: a plane through the
// event with H > 0 on it, or for the inside and the outside of the bounds, the wall.
#pragma once

#include <optional>

#include "topology/classify/wall.h"

namespace isomotion::topology {

struct PartingPlane {
    SpaceBox across{}; // encloses its normal
    SpaceBox at{};     // the event
    SpaceBox around{}; // W: a box around the event in which this holds
    // No plane: no point of the walls in W is in the region.
    bool is_wall = false;

    // -1 or 1 on one side of it, 0 for both.
    int side(const SpaceBox& box) const;
    bool is_around(const SpaceBox& box) const;
};

// Takes an event of index 1, or of index 2 for -G.
std::optional<PartingPlane> parting_plane(const SublevelSet& region, const Event& event);

} // namespace isomotion::topology
