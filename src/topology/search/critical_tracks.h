// Critical points of a moving field at moments of its clock, followed from moment to moment: where
// the value at one changes its sign, an event is near.
//
// A point lives for many moments, so few seeds at each of them find most points, and each event is
// come to from a point nearby. Newton's method from seeds in space and time at once finds fewer
// with more evaluations, nearly all of which come to nothing.
#pragma once

#include <cstdint>
#include <functional>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

struct TrackOptions {
    int seeds = 1 << 16; // for all moments together
    int threads = 1;                        // the result doesn't depend on it
    std::function<bool()> stopped{};        // asked often, from any thread
    std::function<void(double)> progress{}; // the part that is done
};

// Points of space and time near events: most of these, and others. Adds to `evaluations`.
std::vector<Point> near_crossings(const MovingField& field, const TrackOptions& how,
                                  std::int64_t& evaluations);

} // namespace isomotion::topology
