#include "formula/graph/squares.h"

#include <cmath>

#include "formula/graph/degree.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {

bool has_squares(const Graph& graph, NodeId root) {
    const auto all = degrees(graph, root);
    const auto is_curved = [&](NodeId id) { return !all[id] || *all[id] > 1; };
    const auto squares = [&](const Node& node) {
        const auto [a, b, c, d] = node.children;
        if (node.op == Op::multiply) return a == b && is_curved(a);
        return node.op == Op::power && graph.is_constant(b) && std::fmod(graph[b].value, 2) == 0 &&
               is_curved(a);
    };
    for (const NodeId id : nodes_below(graph, std::array{root})) {
        if (squares(graph[id])) return true;
    }
    return false;
}

} // namespace isomotion::formula
