// Saddles of a moving field at the times of its events, followed from event to event.
//
// A saddle below the surface's level crosses that level at an earlier or later event, unless it
// appears and disappears with a minimum in between. So Newton's method, forwards and backwards in
// time from the events' own places, finds nearly all of them. Nothing here needs a proof: paths are
// sought along these saddles and proved afterwards.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/field/point_field.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// The field at a time, or -G for index 2, so that saddles of H have index 1 in both cases.
using FieldAt = std::function<PointField&(double time)>;

// For each event of the index, in order, the saddles with H < 0 at its time. Empty for other
// events, and for the remaining ones once `stopped` returns true.
std::vector<std::vector<SpacePoint>> saddles_at_events(const FieldAt& field,
                                                       std::span<const Event> events, int index,
                                                       const SpaceBox& box,
                                                       const std::function<bool()>& stopped = {});

// The saddles with H < 0 that Newton's method reaches from these points within the distance `most`;
// empty where it doesn't reach one.
std::vector<std::optional<SpacePoint>>
saddles_near(PointField& field, std::span<const SpacePoint> points, double size, double most);

// Saddles that Newton's method reaches from this number of seeds in the box.
std::vector<SpacePoint> saddles_from_seeds(PointField& field, const SpaceBox& box, int seeds);

// Adds the points of `more` that are not in `points` yet.
void add_points(std::vector<SpacePoint>& points, std::span<const SpacePoint> more, double same);

} // namespace isomotion::topology
