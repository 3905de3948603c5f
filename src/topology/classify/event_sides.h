// The two sides of an event, which it joins or separates.
//
// At a critical point of index 1 two nappes of the solid {G < 0} meet. If a path in the solid joins
// them, the event makes or breaks a tunnel; otherwise it joins or separates two components. At a
// point of index 2 the two nappes are of the complement, including the exterior of the bounds: the
// event changes a tunnel or a void. On a wall of the bounds these are the inside and the outside.
#pragma once

#include <array>
#include <optional>

#include "topology/classify/wall.h"

namespace isomotion::topology {

// Points on both sides of an event of index 1 or 2, each connected to the event in the region.
std::optional<std::array<SpacePoint, 2>> both_sides(const SublevelSet& region, const Event& event);

} // namespace isomotion::topology
