// Ways down a field from its saddles to its minima, in doubles.
//
// A proof of the way is to follow, so it need not be the gradient's own: where the field is convex
// Newton's method is faster.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/point_field.h"

namespace isomotion::topology {

// Where ways may go. Of the region outside of the bounds a way has reached its end.
struct Ground {
    SpaceBox box;
    bool is_solid = true;                              // ways stay inside of the bounds
    std::function<bool(const SpacePoint&)> is_inside;  // the bounds
    std::function<bool(const SpacePoint&)> is_outside; // of the bounds, for certain
    double longest = 0.03;                             // step, as a part of the box
};

struct Way {
    std::vector<SpacePoint> points; // from the saddle, or from where it starts, down
    enum class End { lost, minimum, outside } end = End::lost;
};

struct Start {
    SpacePoint from;
    SpacePoint direction; // a unit vector; 0: down the slope
};

// Each by steps over which H falls.
std::vector<Way> ways_down(PointField& field, const Ground& ground, std::span<const Start> starts);

// A saddle and its two ways.
struct Pass {
    double height = 0; // H there
    std::array<Way, 2> ways;
};
// Of saddles along the direction that H bends down in; of other points along a given one.
std::vector<Pass> passes(PointField& field, const Ground& ground,
                         std::span<const SpacePoint> saddles);
std::vector<Pass> passes(PointField& field, const Ground& ground, std::span<const Start> over);

} // namespace isomotion::topology
