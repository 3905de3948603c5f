// Decides by boxes whether the two sides of a saddle are joined elsewhere. Both answers are proofs.
//
// The bounds are divided into boxes, finest where needed. Boxes with H > 0 separate the region {H <
// 0}; boxes with H < 0 join it. The search looks for chains of boxes from one side to the other and
// halves the undecided boxes in them, until there is no chain, or one that lies in the region
// entirely. At the saddle itself a plane with H > 0 separates the two sides
// (docs/topology-proofs.md).
#pragma once

#include <functional>

#include "topology/classify/event_sides.h"

namespace isomotion::topology {

enum class Sides {
    unknown,
    joined, // proved
    apart,  // proved
};

struct PartingOptions {
    std::size_t boxes = 60'000; // at most
    std::function<bool()> stopped{};
};

// Takes an event of index 1, or of index 2 for -G. `starts` come from both_sides().
Sides sides_by_boxes(const SublevelSet& region, const Event& event,
                     const std::array<SpacePoint, 2>& starts, const PartingOptions& how = {});

} // namespace isomotion::topology
