#include "topology/field/kinks.h"

#include <array>
#include <limits>
#include <optional>

#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Node;
using formula::NodeId;
using formula::Op;

// 0 where a node that takes single values has one of them, unbounded on both sides elsewhere.
NodeId unbounded_unless_one(Graph& g, NodeId node) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const NodeId zero = g.constant(0);
    return g.add(g.select(node, node, g.constant(infinity), zero),
                 g.select(node, node, g.constant(-infinity), zero));
}

// What to add for a node; none if slopes of its slopes hold.
std::optional<NodeId> kink_at(Graph& g, NodeId id) {
    const Node node = g[id];
    switch (node.op) {
    case Op::min:
    case Op::max:
    case Op::select: // by how the comparison of the first two comes out
        return unbounded_unless_one(
            g, g.unary(Op::sign, g.subtract(node.children[0], node.children[1])));
    case Op::floor:
    case Op::sign:
    case Op::random: // a jump's slope is unbounded, but the slope of that is not
        return unbounded_unless_one(g, id);
    default:
        return std::nullopt;
    }
}

} // namespace

NodeId kinks(Graph& g, NodeId root) {
    NodeId all = g.constant(0);
    for (const NodeId id : formula::nodes_below(g, std::array{root})) {
        const std::optional<NodeId> found = kink_at(g, id);
        if (!found) continue;
        NodeId kink = *found;
        for (int array = 0; array < formula::max_arrays; ++array) {
            if (g[kink].arrays & (1u << array)) kink = g.sum(array, kink);
        }
        all = g.add(all, kink);
    }
    return all;
}

} // namespace isomotion::topology
