// All that is said in a timeline, made wrong one thing at a time.
#pragma once

#include <string>
#include <vector>

#include "topology/timeline/true_timelines.h"

namespace isomotion::topology {

struct Falsehood {
    std::string what; // "events[2]: index 3"
    TimelineRecord record;
};

// `dt`: times are made wrong by more than that, and places by more than follows from it.
std::vector<Falsehood> falsehoods(const NamedTimeline& truth, double dt);

} // namespace isomotion::topology
