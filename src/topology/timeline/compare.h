// Compares two timelines: events that are missing, new, moved or of another kind.
#pragma once

#include "topology/timeline/check.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// Passes only if all that `expected` says is what was found, and proved there: its start and its
// end, every event with its time, place, stratum, index, direction, kind and numbers, and that
// there are no others in the time that it spans. All of that time must have been searched. What of
// it is in the enclosure of an event's time is not known. An expectation that contradicts itself
// never passes.
//
// Events of the two are matched by kind, place and time so that the least is said: one that has
// moved is moved, not missing and extra. Times may differ by `dt` seconds, places by as much as
// tolerance_of() says. Throws std::invalid_argument if `dt` is negative or not finite.
Check compare(const TimelineRecord& expected, const TimelineRecord& found, double dt);

} // namespace isomotion::topology
