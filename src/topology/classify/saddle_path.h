// Proves by intervals that a path joins two points in the region.
#pragma once

#include <span>

#include "topology/classify/sublevel_set.h"

namespace isomotion::topology {

// Whether a path in the region joins the first corner to the last. The path is close to this
// polyline, but need not equal it. `failed` is the corner before which the proof failed.
bool is_path(const SublevelSet& region, std::span<const SpacePoint> corners,
             std::size_t* failed = nullptr);

} // namespace isomotion::topology
