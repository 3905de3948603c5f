// NAME.betti.csv: Betti numbers to compare an independent program's frames with.
#pragma once

#include <string>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// A line for each whole frame of the timeline's range: frame, b0 b1 b2 of the solid and of its
// surface, whether they are proved, and how many frames it is to the next event and from the last.
// Cells are empty where nothing is known: Betti numbers at the very instant of an event, and events
// beyond the range. What is unresolved counts as an event here.
std::string betti_csv(const TimelineRecord& record);

} // namespace isomotion::topology
