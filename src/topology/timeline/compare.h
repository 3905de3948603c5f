// Compares two timelines: events that are missing, new, moved or of another kind.
#pragma once

#include "topology/timeline/check.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// Passes only if everything that `expected` states was found and proved: its start and its end;
// every event with its time, place, stratum, index, direction, kind and numbers; and that there are
// no other events in the time that it spans. All of that time must have been searched, and the part
// within enclosures of events' times counts as unknown. An expectation that contradicts itself
// never passes.
//
// Events of the two timelines are matched by kind, place and time so that the report is shortest:
// an event that has moved is reported as moved, not as missing and extra. Times may differ by `dt`
// seconds, places by tolerance_of(). Throws std::invalid_argument if `dt` is negative or not
// finite.
Check compare(const TimelineRecord& expected, const TimelineRecord& found, double dt);

} // namespace isomotion::topology
