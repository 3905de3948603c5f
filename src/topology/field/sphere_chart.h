// The sphere that bounds a surface as faces of boxes, so that what happens on it is searched as on
// the walls of a box.
//
// A chart covers a sixth of the sphere, seen from its centre through one face of a cube, and a
// little more. Its coordinates are u and v, the places on that face, which is [-1, 1]^2, and the
// height w, the part of the radius: the sphere is the wall w = 1.
#pragma once

#include <array>
#include <optional>

#include "formula/evaluate/evaluate.h"
#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

class SphereChart {
public:
    // Looks along this axis of x, y, z, up or down.
    SphereChart(std::size_t axis, bool is_up)
        : axis_(axis)
        , is_up_(is_up) {}
    bool operator==(const SphereChart&) const = default;

    // The six of a sphere. Each of its points is in some chart's own part, |u| <= 1 and |v| <= 1.
    static std::array<SphereChart, 6> all();
    // The wall w = 1.
    static Stratum wall();

    // x, y, z of the point u, v at a height, all expressions of the motion's graph: u and v are the
    // inputs 0 and 1.
    std::array<formula::NodeId, 3> place(formula::Graph& graph, const Motion& in_space,
                                         formula::NodeId height) const;
    // u and v of the point that the graph's first inputs are, where `ahead` is above 0: on the
    // chart's side of the centre.
    struct Seen {
        std::array<formula::NodeId, 2> coordinates;
        formula::NodeId ahead;
    };
    Seen seen(formula::Graph& graph, const Motion& in_space) const;

    // The surface in the chart's coordinates; the motion's bounds are a sphere. Its own are a box
    // that reaches a little beyond the chart's own part.
    Motion motion(const Motion& in_space) const;

    // Provably not in the chart's own part.
    static bool is_beyond(formula::Interval u, formula::Interval v);
    // From the centre: of length 1.
    SpaceBox direction(formula::Interval u, formula::Interval v) const;
    // The u and v of all points in such directions, of any length; none where the directions may
    // not all be on the chart's side of the centre.
    std::optional<std::array<formula::Interval, 2>> coordinates(const SpaceBox& direction) const;

private:
    std::size_t axis_;
    bool is_up_;
};

// Where a chart's points are in space. One a thread.
class SpherePlaces {
public:
    // `motion` is the one in space.
    SpherePlaces(const Motion& motion, const SphereChart& chart);

    // A box in space about the points u, v on the sphere at some clocks.
    SpaceBox at(formula::Interval u, formula::Interval v, formula::Interval clock);

private:
    SphereChart chart_;
    formula::Program sphere_; // of the clock: centre and radius
    formula::Evaluator<formula::Interval> evaluator_;
    formula::Bindings<formula::Interval> bindings_;
};

} // namespace isomotion::topology
