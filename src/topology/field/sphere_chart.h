// Represents the sphere that bounds a surface as faces of boxes, so that events on it are searched
// for as on the walls of a box.
//
// A chart covers a sixth of the sphere and a little more, seen from the centre through one face of
// a cube. Its coordinates are u and v, places on that face, which is [-1, 1]^2, and the height w, a
// fraction of the radius. The sphere is the wall w = 1.
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
    // Looks along this axis of x, y, z, in positive or negative direction.
    SphereChart(std::size_t axis, bool is_up)
        : axis_(axis)
        , is_up_(is_up) {}
    bool operator==(const SphereChart&) const = default;

    // The six charts of a sphere. Each of its points is in the own part, |u| <= 1 and |v| <= 1, of
    // some chart.
    static std::array<SphereChart, 6> all();
    // The wall w = 1.
    static Stratum wall();

    // x, y, z of the point u, v at a height, all as expressions of the motion's graph; u and v are
    // inputs 0 and 1.
    std::array<formula::NodeId, 3> place(formula::Graph& graph, const Motion& in_space,
                                         formula::NodeId height) const;
    // u and v of the point given by the graph's first inputs. They are valid where `ahead` is above
    // 0: on the chart's side of the centre.
    struct Seen {
        std::array<formula::NodeId, 2> coordinates;
        formula::NodeId ahead;
    };
    Seen seen(formula::Graph& graph, const Motion& in_space) const;

    // The surface in the chart's coordinates; the motion's bounds must be a sphere. The result's
    // bounds are a box that extends a little beyond the chart's own part.
    Motion motion(const Motion& in_space) const;

    // Whether the place is provably outside of the chart's own part.
    static bool is_beyond(formula::Interval u, formula::Interval v);
    // Unit vectors from the centre.
    SpaceBox direction(formula::Interval u, formula::Interval v) const;
    // The u and v of all points in such directions, of any length; none if some direction may not
    // be on the chart's side of the centre.
    std::optional<std::array<formula::Interval, 2>> coordinates(const SpaceBox& direction) const;

private:
    std::size_t axis_;
    bool is_up_;
};

// The places of a chart's points in space. Use one per thread.
class SpherePlaces {
public:
    // `motion` is the motion in space.
    SpherePlaces(const Motion& motion, const SphereChart& chart);

    // A box in space around the points u, v on the sphere at some clocks.
    SpaceBox at(formula::Interval u, formula::Interval v, formula::Interval clock);

private:
    SphereChart chart_;
    formula::Program sphere_; // of the clock: centre and radius
    formula::Evaluator<formula::Interval> evaluator_;
    formula::Bindings<formula::Interval> bindings_;
};

} // namespace isomotion::topology
