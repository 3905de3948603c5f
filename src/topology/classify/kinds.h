// Finds the kinds of events that index and direction leave open, and the Betti numbers between
// events.
//
// Index and direction leave two kinds for events of index 1 and 2. A proved path between the two
// sides of the saddle shows that the event changes b1 ("path"). The other events are counted
// between proved frames: where only all of them together can explain the known change of b0 or b2,
// the kind of each is determined ("counting"; docs/topology-proofs.md).
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
    // Proved Betti numbers at a time without an event. May be unset, or fail.
    std::function<std::optional<Betti>(double time)> frame{};
    int most_frames = 16; // limit on calls of `frame` to part events while they are counted
    // Boxes part the sides of about so many events in the time that a frame takes.
    int events_a_frame = 16;
    // Once it returns true, no more proofs are requested.
    std::function<bool()> stopped{};
};

// Sets kinds, the Betti numbers before and after events, and doubts where these disagree. The
// timeline must have its events ordered by time with index and direction, and proved Betti numbers
// of its ends, if known. Otherwise these are proved at a nearby time, if possible. Degenerate
// places (Timeline::unresolved) count as unknown: nothing is counted across them.
void find_kinds(Timeline& timeline, const KindProofs& proofs);

// Determines the kinds that follow from the Betti numbers before the first event and after the
// last. Events at one time have no order: they get as many of each kind as these numbers require,
// and the first ones get the kind that changes b0 or b2. Returns false if no kinds agree with the
// numbers.
bool count_kinds(std::span<Event> events, const Betti& before, const Betti& after);

} // namespace isomotion::topology
