// Whether the two sides of a saddle are joined elsewhere, by boxes: proved either way.
//
// The bounds are divided into boxes, where it matters the finest: those where H > 0 part the region
// {H < 0}, those where H < 0 join it. Boxes are sought that lead from one side to the other; what
// is open of these is halved, until none lead there, or such that are all in the region. Beside the
// saddle itself a plane parts the two sides: H > 0 on it (docs/topology-proofs.md).
#pragma once

#include <functional>

#include "topology/classify/saddle_path.h"

namespace isomotion::topology {

enum class Sides {
    unknown,
    joined, // proved
    apart,  // proved
};

struct PartingOptions {
    std::size_t boxes = 30'000; // at most
    std::function<bool()> stopped{};
};

// Takes an event of index 1, or 2 for -G, inside of the bounds; `starts` are those of both_sides().
Sides sides_by_boxes(const SublevelSet& region, const Event& event,
                     const std::array<SpacePoint, 2>& starts, const PartingOptions& how = {});

} // namespace isomotion::topology
