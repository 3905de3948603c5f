// Counts the Betti numbers between events again.
//
// The numbers follow from the kinds of the events, and kinds from paths, boxes and sums. A fault in
// any of these gives numbers that look proved. So spans between two events are counted again at
// some times each, by a way that shares no code with those: by signs of F at the vertices of a
// grid. A grid misses what is finer than its cells, so numbers that differ prove nothing. Where
// grids of three sizes tell the same, and not what the events do, a proof of that one frame
// decides. It shares no code with paths and boxes; sums rest on proofs of other frames.
#pragma once

#include <functional>
#include <optional>

#include "topology/timeline/event.h"

namespace isomotion::topology {

struct Recounting {
    // Counts signs on a grid with so many vertices along each side. Any thread may call it.
    std::function<std::optional<Betti>(double time, int side)> signs{};
    // Proves the numbers of one frame, or fails. Any thread may call it.
    std::function<std::optional<Betti>(double time)> frame{};
    int threads = 1;
    std::function<bool()> stopped{};
    std::function<void(double part)> progress{};
};

// Takes a timeline whose kinds are found. Counts each span whose numbers it has proved, and throws
// an Error (internal) where a proof of a frame has others: neither may be believed.
Recount recount(const Timeline& timeline, const Recounting& how);

} // namespace isomotion::topology
