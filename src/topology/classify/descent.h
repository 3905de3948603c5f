// Computes paths down a field from its saddles to its minima, in doubles.
//
// Each path is proved afterwards, so it need not follow the gradient. Where the field is convex,
// Newton's method is faster.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/field/point_field.h"

namespace isomotion::topology {

// The domain of paths. A path that leaves the bounds has reached its end.
struct Domain {
    SpaceBox box;
    bool is_solid = true;                              // paths stay inside of the bounds
    std::function<bool(const SpacePoint&)> is_inside;  // the bounds
    std::function<bool(const SpacePoint&)> is_outside; // certainly outside of the bounds
    double longest = 0.03;                             // longest step, as a fraction of the box
    // The bounds, if they are a sphere.
    struct Sphere {
        SpacePoint centre{};
        double radius = 0;
    };
    std::optional<Sphere> sphere{};
};

struct DescentPath {
    std::vector<SpacePoint> points; // down from the saddle or the start
    enum class End { lost, minimum, outside } end = End::lost;
};

struct Start {
    SpacePoint from;
    SpacePoint direction; // a unit vector; 0: down the gradient
};

// Each path takes steps over which H falls.
std::vector<DescentPath> descent_paths(PointField& field, const Domain& domain,
                                       std::span<const Start> starts);

// A saddle and the two paths down from it.
struct SaddleConnection {
    double height = 0; // H there
    std::array<DescentPath, 2> paths;
};
// Paths leave saddles along the direction of least curvature, other points along a given direction.
std::vector<SaddleConnection> saddle_connections(PointField& field, const Domain& domain,
                                                 std::span<const SpacePoint> saddles);
std::vector<SaddleConnection> saddle_connections(PointField& field, const Domain& domain,
                                                 std::span<const Start> over);

} // namespace isomotion::topology
