// Critical points of a moving field at moments of its clock, followed from moment to moment. Where
// the value at one changes its sign, an event is near.
//
// A point exists for many moments, so a few seeds at each moment find most points, and each event
// is reached from a nearby point. Newton's method from seeds in space and time together finds fewer
// events with more evaluations, most of which are in vain.
#pragma once

#include <cstdint>
#include <functional>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

struct TrackOptions {
    int seeds = 1 << 16;                    // for all moments together
    int threads = 1;                        // the result doesn't depend on it
    std::function<bool()> stopped{};        // called often, from any thread
    std::function<void(double)> progress{}; // the finished part
};

// Points in space and time near events: near most of them, and other points. Adds to `evaluations`.
std::vector<Point> near_crossings(const MovingField& field, const TrackOptions& how,
                                  std::int64_t& evaluations);

} // namespace isomotion::topology
