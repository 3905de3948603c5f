// NAME.betti.csv: Betti numbers for comparison with an independent program's frames.
#pragma once

#include <string>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// One line for each whole frame of the timeline's range: frame; b0 b1 b2 of the solid and of its
// surface; whether they are proved; the number of frames to the next event and since the last.
// Cells are empty where nothing is known: Betti numbers at the time of an event, and events beyond
// the range. Unresolved places count as events here.
std::string betti_csv(const TimelineRecord& record);

} // namespace isomotion::topology
