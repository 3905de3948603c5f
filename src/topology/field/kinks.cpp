#include "topology/field/kinks.h"

#include <array>
#include <limits>

#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Node;
using formula::NodeId;
using formula::Op;

// 0 where the comparison a < b has one outcome, unbounded on both sides elsewhere.
NodeId undecided(Graph& g, NodeId a, NodeId b) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const NodeId side = g.unary(Op::sign, g.subtract(a, b));
    const NodeId zero = g.constant(0);
    return g.add(g.select(side, side, g.constant(infinity), zero),
                 g.select(side, side, g.constant(-infinity), zero));
}

} // namespace

NodeId kinks(Graph& g, NodeId root) {
    NodeId all = g.constant(0);
    for (const NodeId id : formula::nodes_below(g, std::array{root})) {
        const Node node = g[id];
        if (node.op != Op::min && node.op != Op::max && node.op != Op::select) continue;
        NodeId kink = undecided(g, node.children[0], node.children[1]);
        for (int array = 0; array < formula::max_arrays; ++array) {
            if (g[kink].arrays & (1u << array)) kink = g.sum(array, kink);
        }
        all = g.add(all, kink);
    }
    return all;
}

} // namespace isomotion::topology
