// Compares two timelines: events that are missing, new, moved or of another kind.
#pragma once

#include "topology/timeline/check.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// Events of the two are matched by kind, place and time so that the least is said: one that has
// moved is moved, not missing and extra. Times may differ by `dt` seconds. Only what both timelines
// prove can pass or differ; the rest is undecided. Compared is the time that `expected` spans.
Check compare(const TimelineRecord& expected, const TimelineRecord& found, double dt);

} // namespace isomotion::topology
