// Finds contradictions within a timeline.
//
// A timeline states its numbers many times: at the start, before and after each event, at the end,
// and by each event's kind. If all of these agree, two timelines with the same start and the same
// events have the same numbers throughout, and it suffices to compare those.
#pragma once

#include <string>
#include <vector>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// One line each. Empty for a timeline that is not complete, which itself states that it doesn't
// know everything.
std::vector<std::string> contradictions(const Timeline& timeline, animation::FrameRate fps);

} // namespace isomotion::topology
