#include "topology/field/sphere_chart.h"

#include "formula/graph/substitute.h"
#include "formula/interval/interval_operations.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

// The chart's box reaches so far: points on the edge of a chart's own part are well inside of it.
constexpr double reach = 1.0625;

} // namespace

std::array<SphereChart, 6> SphereChart::all() {
    return {SphereChart{0, true},  SphereChart{0, false}, SphereChart{1, true},
            SphereChart{1, false}, SphereChart{2, true},  SphereChart{2, false}};
}

Stratum SphereChart::wall() {
    return {{Stratum::End::free, Stratum::End::free, Stratum::End::high}};
}

std::array<NodeId, 3> SphereChart::place(Graph& g, const Motion& in_space, NodeId height) const {
    const NodeId u = g.input(0), v = g.input(1);
    const NodeId squared = g.add(g.add(g.constant(1), g.multiply(u, u)), g.multiply(v, v));
    const NodeId scale = g.divide(g.multiply(in_space.radius, height), g.unary(Op::sqrt, squared));
    std::array<NodeId, 3> made{};
    made[axis_] = is_up_ ? scale : g.unary(Op::negate, scale);
    made[(axis_ + 1) % 3] = g.multiply(u, scale);
    made[(axis_ + 2) % 3] = g.multiply(v, scale);
    for (std::size_t k = 0; k < 3; ++k) made[k] = g.add(in_space.centre[k], made[k]);
    return made;
}

SphereChart::Seen SphereChart::seen(Graph& g, const Motion& in_space) const {
    std::array<NodeId, 3> off{};
    for (std::size_t k = 0; k < 3; ++k) off[k] = g.subtract(g.input(int(k)), in_space.centre[k]);
    const NodeId ahead = is_up_ ? off[axis_] : g.unary(Op::negate, off[axis_]);
    return {{g.divide(off[(axis_ + 1) % 3], ahead), g.divide(off[(axis_ + 2) % 3], ahead)}, ahead};
}

Motion SphereChart::motion(const Motion& in_space) const {
    Motion made = in_space;
    Graph& g = made.graph;
    const std::array<NodeId, 3> at = place(g, in_space, g.input(2));
    made.field = formula::substitute(
        g, g, std::array{in_space.field}, [&](Graph&, const Node& node, NodeId rebuilt) {
            const bool is_place = node.op == Op::input && node.index < clock_input;
            return is_place ? at[std::size_t(node.index)] : rebuilt;
        })[0];
    made.shape = scene::Bounds::Shape::box;
    made.low = {g.constant(-reach), g.constant(-reach), g.constant(0)};
    made.high = {g.constant(reach), g.constant(reach), g.constant(1)};
    return made;
}

bool SphereChart::is_beyond(Interval u, Interval v) { return mignitude(u) > 1 || mignitude(v) > 1; }

SpaceBox SphereChart::direction(Interval u, Interval v) const {
    const Interval length =
        formula::Operations<Interval>::sqrt(Interval(1) + square(u) + square(v));
    SpaceBox made;
    made[axis_] = Interval(is_up_ ? 1 : -1) / length;
    made[(axis_ + 1) % 3] = u / length;
    made[(axis_ + 2) % 3] = v / length;
    return made;
}

std::optional<std::array<Interval, 2>> SphereChart::coordinates(const SpaceBox& direction) const {
    const Interval along = is_up_ ? direction[axis_] : -direction[axis_];
    if (!(along.lo > 0)) return std::nullopt;
    return std::array{direction[(axis_ + 1) % 3] / along, direction[(axis_ + 2) % 3] / along};
}

SpherePlaces::SpherePlaces(const Motion& motion, const SphereChart& chart)
    : chart_(chart)
    , sphere_(formula::schedule(motion.graph, std::array{motion.centre[0], motion.centre[1],
                                                         motion.centre[2], motion.radius}))
    , evaluator_(sphere_)
    , bindings_(formula::convert<Interval>(motion.bindings)) {}

SpaceBox SpherePlaces::at(Interval u, Interval v, Interval clock) {
    const std::array<Interval, 4> inputs{0.0, 0.0, 0.0, clock};
    std::array<Interval, 4> sphere;
    evaluator_.point(bindings_, inputs, sphere);
    SpaceBox made = chart_.direction(u, v);
    for (std::size_t k = 0; k < 3; ++k) made[k] = sphere[k] + sphere[3] * made[k];
    return made;
}

} // namespace isomotion::topology
