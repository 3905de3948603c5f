// In what an event is another than the one that was expected: every field of the two is compared.
#pragma once

#include <string>
#include <vector>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// By how much events may have moved and still be the same.
struct Tolerance {
    double time = 0;  // seconds
    double place = 0; // formula coordinates
};

// The diagonal of the bounds; 1 where they have none.
double diagonal(const TimelineHeader& header);

// Places may differ by a millionth of the diagonal of the bounds of what was found, or by the part
// of it that `dt` is of the time that was searched. Both are taken of what was found: no
// expectation widens its own tolerance.
Tolerance tolerance_of(const TimelineRecord& found, double dt);

// Between the nearest members of two intervals; between the nearest members of two places.
double least_distance(formula::Interval a, formula::Interval b);
double place_distance(const Event& a, const Event& b);

// What is said of each event of a moment is that it has one of the two kinds that its index leaves.
bool may_change_kinds(const Event& a, const Event& b);

struct EventDifference {
    std::string line;
    bool is_open = false; // it is not proved that they differ, nor that they agree
};

// Empty where the two agree. Numbers before and after are compared by what the event adds to them:
// what they are follows from the start (see contradictions.h). Kinds that may be changed with
// others of a moment are not compared.
std::vector<EventDifference> differences(const Event& wanted, const Event& event,
                                         const Tolerance& tolerance, animation::FrameRate fps);

// "at frame 10.5 (0.95 s), near (0.5, 0, 0)"
std::string place_text(const Event& event, animation::FrameRate fps);

} // namespace isomotion::topology
