// The solid's Betti numbers as a function of time: steps that last from event to event.
#pragma once

#include <optional>
#include <vector>

#include "topology/timeline/event.h"

namespace isomotion::topology {

// Events that are not told apart in time, their enclosures overlapping, and what is unresolved
// among them. Events on the bounds that change nothing (Kind::none) are in no instant.
struct Instant {
    formula::Interval time;
    std::vector<std::size_t> events, unresolved; // positions in the timeline's lists
};

struct Step {
    formula::Interval time;     // from the end of an instant to the beginning of the next
    std::optional<Betti> solid; // as far as the timeline says
    // `solid` follows from a proved end by proved events of known kinds, certainly in the range and
    // none of them missing.
    bool is_proved = false;
};

// steps[k] comes before instants[k]; there is one step more than instants.
struct Steps {
    std::vector<Step> steps;
    std::vector<Instant> instants;

    // The step that holds a time; null at an instant and out of range.
    const Step* at(double time) const;
};

Steps steps_of(const Timeline& timeline);

} // namespace isomotion::topology
