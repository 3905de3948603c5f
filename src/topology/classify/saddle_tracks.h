// Saddles of a moving field at the times of its events, followed from event to event.
//
// A saddle below the surface's level crossed it, before or later, at an event, unless it came and
// went with a minimum meanwhile: so from the events' own places Newton's method, forwards and back
// in time, gets to nearly all of them. Nothing is proved here and nothing need be: paths are sought
// along saddles, and proved afterwards.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/field/point_field.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// A field whose values are those of a time, -G for index 2: saddles of H are of index 1 for both.
using FieldAt = std::function<PointField&(double time)>;

// For each event of the index, in order, the saddles with H < 0 then; empty for other events, and
// for what is left once `stopped` is true.
std::vector<std::vector<SpacePoint>> saddles_at_events(const FieldAt& field,
                                                       std::span<const Event> events, int index,
                                                       const SpaceBox& box,
                                                       const std::function<bool()>& stopped = {});

// The saddles with H < 0 that Newton's method gets to from these points, over `most` at most; empty
// where it doesn't.
std::vector<std::optional<SpacePoint>>
saddles_near(PointField& field, std::span<const SpacePoint> points, double size, double most);

// Saddles that Newton's method gets to from so many seeds in the box.
std::vector<SpacePoint> saddles_from_seeds(PointField& field, const SpaceBox& box, int seeds);

// Adds those of `more` that are not there yet.
void add_points(std::vector<SpacePoint>& points, std::span<const SpacePoint> more, double same);

} // namespace isomotion::topology
