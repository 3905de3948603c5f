// Compares an event with the one expected, in every field.
#pragma once

#include <string>
#include <vector>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// How far events may have moved and still count as the same.
struct Tolerance {
    double time = 0;  // seconds
    double place = 0; // formula coordinates
};

// The diagonal of the bounds; 1 if they have none.
double diagonal(const TimelineHeader& header);

// Places may differ by a millionth of the diagonal of the bounds found, or by the fraction of it
// that `dt` is of the time searched. Both come from the timeline found, so no expectation widens
// its own tolerance.
Tolerance tolerance_of(const TimelineRecord& found, double dt);

// The distance between the nearest members of two intervals, and of two events' places.
double least_distance(formula::Interval a, formula::Interval b);
double place_distance(const Event& a, const Event& b);

// Whether both events only state that they have one of the two kinds that the index leaves.
bool may_change_kinds(const Event& a, const Event& b);

struct EventDifference {
    std::string line;
    bool is_open = false; // neither a difference nor agreement is proved
};

// Empty if the two agree. Numbers before and after are compared by the change that the event makes,
// since their values follow from the start (see contradictions.h). Kinds that are interchangeable
// with others at the same time are not compared.
std::vector<EventDifference> differences(const Event& wanted, const Event& event,
                                         const Tolerance& tolerance, animation::FrameRate fps);

// "at frame 10.5 (0.95 s), near (0.5, 0, 0)"
std::string place_text(const Event& event, animation::FrameRate fps);

} // namespace isomotion::topology
