// Where a timeline says one thing in one place and another thing in another.
//
// Its numbers are said many times: at the start, before and after each event, at the end, and by
// each event's kind. Once all of these agree, two timelines with the same start and the same events
// have the same numbers throughout, and it is enough to compare those.
#pragma once

#include <string>
#include <vector>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// A line each. Empty for a timeline that is not complete: it says itself that not all is known.
std::vector<std::string> contradictions(const Timeline& timeline, animation::FrameRate fps);

} // namespace isomotion::topology
