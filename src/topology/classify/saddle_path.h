// Proves by intervals that a path joins the two sides of a saddle elsewhere.
//
// At a critical point of index 1 two nappes of the solid {G < 0} meet. If a path in the solid joins
// them, the event makes or breaks a tunnel; otherwise it joins or separates two components. At a
// point of index 2 the two nappes are of the complement, including the exterior of the bounds: the
// event changes a tunnel or a void.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "topology/classify/sublevel_set.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// Points on both sides of an event of index 1 or 2, each connected to the event in the region.
std::optional<std::array<SpacePoint, 2>> both_sides(const SublevelSet& region, const Event& event);

// Whether a path in the region joins the first corner to the last. The path is close to this
// polyline, but need not equal it. `failed` is the corner before which the proof failed.
bool is_path(const SublevelSet& region, std::span<const SpacePoint> corners,
             std::size_t* failed = nullptr);

} // namespace isomotion::topology
