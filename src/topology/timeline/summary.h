// Summarizes a timeline in a few lines, for the terminal.
#pragma once

#include <string>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// What was searched, Betti numbers from start to end, the number of events of each kind with their
// first and last time, and whether that is complete and proved, or what is missing. Lines end with
// a newline.
std::string summary(const TimelineRecord& record);

// "74 merges, 68 tunnels form": in the order of Kind; "no event", or "no event found" if that is
// not proved.
std::string tally(const Timeline& timeline);

} // namespace isomotion::topology
