#include "topology/field/reciprocals.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Node;
using formula::NodeId;
using formula::Op;

struct Power {
    NodeId of{};
    int exponent = 1;
};

Power as_power(const Graph& g, NodeId id) {
    const Node& node = g[id];
    if (node.op != Op::multiply) return {id, 1};
    const Power a = as_power(g, node.children[0]), b = as_power(g, node.children[1]);
    if (a.of != b.of) return {id, 1};
    return {a.of, a.exponent + b.exponent};
}

bool depends_on_inputs(const Graph& g, NodeId root) {
    return std::ranges::any_of(formula::nodes_below(g, std::array{root}),
                               [&](NodeId id) { return g[id].op == Op::input; });
}

} // namespace

NodeId with_reciprocals(Graph& graph, NodeId root) {
    const auto rewrite = [&](Graph& g, const Node&, NodeId rebuilt) {
        const Node node = g[rebuilt];
        if (node.op != Op::divide) return rebuilt;
        const Power divisor = as_power(g, node.children[1]);
        if (divisor.exponent < 2 || depends_on_inputs(g, node.children[0])) return rebuilt;
        const NodeId reciprocal = g.divide(g.constant(1), divisor.of);
        return g.multiply(node.children[0], g.integer_power(reciprocal, divisor.exponent));
    };
    return formula::substitute(graph, graph, std::array{root}, rewrite).front();
}

} // namespace isomotion::topology
