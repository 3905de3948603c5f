// Timelines that are true of something: those that are kept, and made-up ones with every kind of
// event, on every stratum, at once and at the ends of what was searched.
#pragma once

#include <string>
#include <vector>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

struct NamedTimeline {
    std::string name;
    TimelineRecord record;
    std::size_t every = 1; // falsified is one of so many events: long ones have many alike

    friend std::ostream& operator<<(std::ostream& out, const NamedTimeline& timeline) {
        return out << timeline.name;
    }
};

std::vector<NamedTimeline> complete_timelines();
// Timelines with a place that is unresolved, an event that is not proved and the like: nothing
// passes.
std::vector<NamedTimeline> incomplete_timelines();

// Writes all numbers anew by the start and the kinds, as somebody does who keeps a file in itself
// right. A number that would be negative stays 0.
void follow_from_start(Timeline& timeline);

} // namespace isomotion::topology
