// A timeline in a few lines, for the terminal.
#pragma once

#include <string>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// What was searched, Betti numbers from start to end, how many events of each kind and from when to
// when, and whether that is all and proved, or what is missing. Lines with their ends.
std::string summary(const TimelineRecord& record);

// "74 merges, 68 tunnels form": in the order of Kind; "no event", or where that is not
// proved "no event found".
std::string tally(const Timeline& timeline);

} // namespace isomotion::topology
