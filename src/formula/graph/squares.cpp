#include "formula/graph/squares.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formula/graph/degree.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {

bool has_squares(const Graph& graph, NodeId root) {
    const std::vector<NodeId> nodes = nodes_below(graph, std::array{root});
    const auto degree_of = degrees(graph, root);
    // What a node is a power of: u of (u^2)^2, too, which a graph makes of u^4.
    std::vector<NodeId> base(std::size_t(root) + 1);
    for (const NodeId id : nodes) {
        const auto [a, b, c, d] = graph[id].children;
        const bool multiplies = graph[id].op == Op::multiply && base[a] == base[b];
        const bool raises = graph[id].op == Op::power && graph.is_constant(b);
        base[id] = multiplies || raises ? base[a] : id;
    }
    const auto is_curved = [&](NodeId id) { return !degree_of[id] || *degree_of[id] > 1; };
    const auto squares = [&](NodeId id) {
        const auto [a, b, c, d] = graph[id].children;
        if (graph[id].op == Op::multiply) return a == b && is_curved(base[a]);
        return graph[id].op == Op::power && graph.is_constant(b) &&
               std::fmod(graph[b].value, 2) == 0 && is_curved(base[a]);
    };
    return std::ranges::any_of(nodes, squares);
}

} // namespace isomotion::formula
