#include "formula/graph/substitute.h"

#include <unordered_map>

namespace isomotion::formula {

NodeId remade(Graph& to, const Node& node, const std::array<NodeId, 4>& children, int first_array) {
    switch (node.op) {
    case Op::constant:
        return to.constant(node.value);
    case Op::input:
        return to.input(node.index);
    case Op::parameter:
        return to.parameter(node.index);
    case Op::element:
        return to.element(first_array + node.index, node.second);
    case Op::select:
        return to.select(children[0], children[1], children[2], children[3], Op(node.index));
    case Op::at:
        return to.at(node.index, {children[0], children[1], children[2]});
    case Op::noise:
        return to.noise({children[0], children[1], children[2]}, NoiseOrder::unpacked(node.index));
    case Op::chebyshev:
        return to.chebyshev(node.index, children[0], node.second);
    case Op::sum:
        return to.sum(first_array + node.index, children[0]);
    case Op::least:
        return to.least(first_array + node.index, children[0]);
    case Op::pick:
        return to.pick(first_array + node.index, children[0], children[1]);
    case Op::which:
        return to.which(first_array + node.index, children[0]);
    default:
        return node.arity == 1 ? to.unary(node.op, children[0])
                               : to.binary(node.op, children[0], children[1]);
    }
}

namespace {

enum class Sums { entered, kept };

std::vector<NodeId> nodes_below(const Graph& graph, std::span<const NodeId> roots, Sums sums) {
    NodeId last = 0;
    for (const NodeId root : roots) last = std::max(last, root);
    std::vector<bool> live(std::size_t(last) + 1, false);
    for (const NodeId root : roots) live[root] = true;
    for (NodeId id = last + 1; id-- > 0;) {
        if (!live[id]) continue;
        const Node& node = graph[id];
        if (sums == Sums::kept && is_over_elements(node.op)) continue;
        for (int k = 0; k < node.arity; ++k) live[node.children[std::size_t(k)]] = true;
    }
    std::vector<NodeId> below;
    for (NodeId id = 0; id <= last && !roots.empty(); ++id) {
        if (live[id]) below.push_back(id);
    }
    return below;
}

std::vector<NodeId> substitute(Graph& to, const Graph& from, std::span<const NodeId> roots,
                               const Replacement& replacement, int first_array, Sums sums) {
    std::unordered_map<NodeId, NodeId> stands_for;
    for (const NodeId id : nodes_below(from, roots, sums)) {
        const Node node = from[id]; // a copy: the graph may grow
        if (sums == Sums::kept && is_over_elements(node.op)) {
            stands_for[id] = id;
            continue;
        }
        std::array<NodeId, 4> children{};
        for (std::size_t k = 0; k < node.arity; ++k) {
            children[k] = stands_for.at(node.children[k]);
        }
        stands_for[id] = replacement(to, node, remade(to, node, children, first_array));
    }
    std::vector<NodeId> result;
    for (const NodeId root : roots) result.push_back(stands_for.at(root));
    return result;
}

} // namespace

std::vector<NodeId> nodes_below(const Graph& graph, std::span<const NodeId> roots) {
    return nodes_below(graph, roots, Sums::entered);
}

std::vector<NodeId> substitute(Graph& to, const Graph& from, std::span<const NodeId> roots,
                               const Replacement& replacement, int first_array) {
    return substitute(to, from, roots, replacement, first_array, Sums::entered);
}

NodeId substitute_outside_sums(Graph& graph, NodeId root, const Replacement& replacement) {
    return substitute(graph, graph, std::array{root}, replacement, 0, Sums::kept).front();
}

} // namespace isomotion::formula
