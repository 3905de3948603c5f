// Whether the two sides of a saddle are joined elsewhere: a path, proved by intervals.
//
// At a critical point of index 1 two nappes of the solid {G < 0} meet; if a path in the solid joins
// them, the event makes or breaks a tunnel, else it joins or parts two components. At one of index
// 2 it is two nappes of what isn't solid, outside of the bounds included: a tunnel or a void.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "topology/classify/sublevel_set.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// Points on both sides of an event of index 1 or 2, each joined to it in the region.
std::optional<std::array<SpacePoint, 2>> both_sides(const SublevelSet& region, const Event& event);

// Whether a path in the region joins the first corner to the last; it need not be this polyline,
// but is close to it. `failed` is the corner before which the proof failed.
bool is_path(const SublevelSet& region, std::span<const SpacePoint> corners,
             std::size_t* failed = nullptr);

} // namespace isomotion::topology
