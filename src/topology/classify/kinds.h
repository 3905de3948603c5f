// Finds the kinds of events that index and direction leave open, and the Betti numbers between
// events.
//
// Index and direction leave two kinds for events of index 1 and 2. A proved path between the two
// sides of the saddle says that it is the one that changes b1 ("path"). The others are counted
// between proved frames: where they can only together make up the known change of b0 or b2, each of
// them is forced ("counting"; docs/topology-proofs.md).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/classify/event_paths.h"

namespace isomotion::topology {

struct KindProofs {
    // Seeks paths for the events at these positions, with an effort of 0 to 2.
    std::function<std::vector<Sides>(std::span<const std::size_t> which, int effort)> paths{};
    // Proved Betti numbers at a time without an event; may be missing, or fail.
    std::function<std::optional<Betti>(double time)> frame{};
    int most_frames = 16; // asked for
    // Once true, nothing more is asked for.
    std::function<bool()> stopped{};
};

// Kinds, Betti numbers before and after, and doubts where these don't agree. The timeline has its
// events by time with index and direction, and proved Betti numbers of its ends, if known; else
// they are proved of a time near, if they can be. Degenerate places (Timeline::unresolved) count as
// unknown: nothing is counted across them.
void find_kinds(Timeline& timeline, const KindProofs& proofs);

// Kinds of those events that are forced by the Betti numbers before the first and after the last.
// Events at one time have no order: they get as many of each kind as these numbers say, and the
// first ones get the kind that changes b0 or b2. False if no kinds agree with the numbers.
bool count_kinds(std::span<Event> events, const Betti& before, const Betti& after);

} // namespace isomotion::topology
