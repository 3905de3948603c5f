// Paths down a field from its saddles to its minima, in doubles.
//
// Each is proved afterwards, so it need not follow the gradient: where the field is convex Newton's
// method is faster.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/field/point_field.h"

namespace isomotion::topology {

// Where paths may go. A path that leaves the bounds has reached its end.
struct Domain {
    SpaceBox box;
    bool is_solid = true;                              // paths stay inside of the bounds
    std::function<bool(const SpacePoint&)> is_inside;  // the bounds
    std::function<bool(const SpacePoint&)> is_outside; // certainly out of the bounds
    double longest = 0.03;                             // step, as a part of the box
};

struct DescentPath {
    std::vector<SpacePoint> points; // from the saddle, or from where it starts, down
    enum class End { lost, minimum, outside } end = End::lost;
};

struct Start {
    SpacePoint from;
    SpacePoint direction; // a unit vector; 0: down the gradient
};

// Each by steps over which H falls.
std::vector<DescentPath> descent_paths(PointField& field, const Domain& domain,
                                       std::span<const Start> starts);

// A saddle and the two paths down from it.
struct SaddleConnection {
    double height = 0; // H there
    std::array<DescentPath, 2> paths;
};
// Saddles are left along the direction of least curvature, other points along a given one.
std::vector<SaddleConnection> saddle_connections(PointField& field, const Domain& domain,
                                                 std::span<const SpacePoint> saddles);
std::vector<SaddleConnection> saddle_connections(PointField& field, const Domain& domain,
                                                 std::span<const Start> over);

} // namespace isomotion::topology
