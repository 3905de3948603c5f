#include "formula/graph/walls.h"

#include "formula/graph/decoration.h"
#include "formula/graph/derivative.h"

namespace isomotion::formula {
namespace {

using NodeVector = std::array<NodeId, 3>;

NodeId dot(Graph& g, const NodeVector& a, const NodeVector& b) {
    NodeId sum = g.constant(0);
    for (std::size_t k = 0; k < 3; ++k) sum = g.add(sum, g.multiply(a[k], b[k]));
    return sum;
}

NodeVector gradient(Graph& g, NodeId root) {
    NodeVector slopes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<NodeId> along(3, g.constant(0));
        along[axis] = g.constant(1);
        slopes[axis] = differentiate_inputs(g, root, along);
    }
    return slopes;
}

// What is 0 where the operation jumps or has its pole; constant for others.
NodeId place_of(Graph& g, NodeId id) {
    const Node node = g[id];
    const NodeId a = node.children[0], b = node.children[1];
    switch (node.op) {
    case Op::sign:
        return a;
    case Op::floor:
        return g.subtract(a, g.unary(Op::floor, g.add(a, g.constant(0.5))));
    case Op::select:
        return g.subtract(a, b);
    case Op::atan2:
        return g.select(b, g.constant(0), a, g.constant(1));
    case Op::angle: // at its axis, which is a surface where a is 0 throughout
        return g.add(g.unary(Op::abs, a), g.unary(Op::abs, b));
    case Op::divide:
        return b;
    case Op::power:
        return a;
    default:
        return g.constant(1);
    }
}

// The sum over all places p = 0 of grad p / |p|, each as long as one over the distance, so that the
// nearest outweighs the others by far.
NodeVector towards_places(Graph& g, NodeId root, double least_distance) {
    NodeVector sum{g.constant(0), g.constant(0), g.constant(0)};
    for (const NodeId id : nodes_below(g, std::array{root})) {
        const NodeId place = place_of(g, id);
        if (g.is_constant(place)) continue;
        const NodeVector slope = gradient(g, place);
        const NodeId size = g.unary(Op::sqrt, dot(g, slope, slope));
        const NodeId length =
            g.add(g.unary(Op::abs, place), g.multiply(g.constant(least_distance), size));
        const NodeId known = g.select(g.constant(0), size, length, g.constant(1));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const NodeId part = g.divide(slope[axis], known);
            sum[axis] = g.add(sum[axis], of_any_element(g, part));
        }
    }
    return sum;
}

// F at a point, off by a vector.
NodeId moved(Graph& g, NodeId root, const NodeVector& by) {
    const Graph from = g;
    const auto shift = [&](Graph& to, const Node& node, NodeId rebuilt) {
        // Other inputs stand for the largest terms of sums, in_range.h: any will do there.
        const bool is_place = node.op == Op::input && std::size_t(node.index) < by.size();
        return is_place ? to.add(rebuilt, by[std::size_t(node.index)]) : rebuilt;
    };
    return substitute(g, from, std::array{root}, shift).front();
}

} // namespace

std::array<NodeId, 3> wall_gradient(Graph& g, NodeId root, double distance) {
    const NodeVector towards = towards_places(g, root, distance * 0x1p-10);
    const NodeId size = g.unary(Op::sqrt, dot(g, towards, towards));
    const NodeId near = g.constant(1 / distance);
    const NodeId known = g.select(near, size, size, near);
    NodeVector ahead{}, behind{}, wall = gradient(g, root);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const NodeId step = g.multiply(g.constant(4 * distance), g.divide(towards[axis], known));
        ahead[axis] = step;
        behind[axis] = g.unary(Op::negate, step);
    }
    const NodeId falls =
        g.select(moved(g, root, ahead), moved(g, root, behind), g.constant(-1), g.constant(1));
    for (std::size_t axis = 0; axis < 3; ++axis)
        wall[axis] = g.select(near, size, g.multiply(falls, towards[axis]), wall[axis]);
    return wall;
}

} // namespace isomotion::formula
