#include "formula/graph/continuity.h"

#include <array>
#include <limits>

#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

NodeId entire(Graph& g) { return g.constant(std::numeric_limits<double>::quiet_NaN()); }

// 0 where a node that takes single values has one of them: an interval that isn't a point is
// neither less than itself nor not.
NodeId unless_one_value(Graph& g, NodeId node) {
    return g.select(node, node, entire(g), g.constant(0));
}

// 0 where a node has bounds: an interval is below the point at infinity, which begins at the
// largest number, if it has an upper one.
NodeId unless_bounded(Graph& g, NodeId node) {
    return g.select(g.unary(Op::abs, node), g.constant(std::numeric_limits<double>::infinity()),
                    g.constant(0), entire(g));
}

NodeId unless_without_kink(Graph& g, NodeId id) {
    const Node node = g[id];
    if (node.op != Op::min && node.op != Op::max && node.op != Op::select) return g.constant(0);
    // By how the comparison of the first two comes out.
    return unless_one_value(g, g.unary(Op::sign, g.subtract(node.children[0], node.children[1])));
}

// The sum of `decoration` of each node below, over the elements of each array that it is of.
template<class Decoration> NodeId all_below(Graph& g, NodeId root, Decoration&& decoration) {
    NodeId all = g.constant(0);
    for (const NodeId id : nodes_below(g, std::array{root})) {
        NodeId one = decoration(g, id);
        for (int array = 0; array < max_arrays; ++array) {
            if (g[one].arrays & (1u << array)) one = g.sum(array, one);
        }
        all = g.add(all, one);
    }
    return all;
}

} // namespace

bool may_be_unbounded(Op op) {
    switch (op) {
    case Op::divide:
    case Op::power:
    case Op::exp:
    case Op::log:
    case Op::tan:
    case Op::sinh:
    case Op::cosh:
        return true;
    default:
        return false;
    }
}

NodeId unless_continuous(Graph& g, NodeId id) {
    const Node node = g[id];
    if (node.op == Op::floor || node.op == Op::sign || node.op == Op::random)
        return unless_one_value(g, id);
    if (node.op == Op::select && node.children[2] != node.children[3])
        return unless_without_kink(g, id);
    return may_be_unbounded(node.op) ? unless_bounded(g, id) : g.constant(0);
}

NodeId jumps(Graph& g, NodeId root) { return all_below(g, root, unless_continuous); }

NodeId kinks(Graph& g, NodeId root) { return all_below(g, root, unless_without_kink); }

} // namespace isomotion::formula
