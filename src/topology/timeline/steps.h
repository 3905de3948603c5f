// The solid's Betti numbers as a step function of time, constant between events.
#pragma once

#include <optional>
#include <vector>

#include "topology/timeline/event.h"

namespace isomotion::topology {

// Events whose enclosures of time overlap, so that their order is unknown, with the unresolved
// places among them. Events on the bounds that change nothing (Kind::none) are in no instant.
struct Instant {
    formula::Interval time;
    std::vector<std::size_t> events, unresolved; // positions in the timeline's lists
};

struct Step {
    formula::Interval time;     // from the end of an instant to the beginning of the next
    std::optional<Betti> solid; // as far as the timeline knows it
    // `solid` follows from a proved end by proved events of known kinds, all certainly in the range
    // and none missing.
    bool is_proved = false;
};

// steps[k] comes before instants[k]; there is one more step than instants.
struct Steps {
    std::vector<Step> steps;
    std::vector<Instant> instants;

    // The step that holds a time; null at an instant and outside of the range.
    const Step* at(double time) const;
};

Steps steps_of(const Timeline& timeline);

} // namespace isomotion::topology
