#include "formula/sums_apart.h"

#include <algorithm>
#include <array>

#include "formula/graph/substitute.h"

namespace isomotion::formula {

std::vector<NodeId> sums_over(const Graph& graph, std::span<const NodeId> roots, int array) {
    std::vector<NodeId> sums;
    for (const NodeId id : nodes_below(graph, roots)) {
        const Node& node = graph[id];
        if (node.op != Op::sum) continue;
        const NodeId term = node.children[0];
        const bool over_it = node.index == array;
        const std::uint32_t in_loops = node.arrays | graph[term].arrays, own = 1u << array;
        const bool is_nested = over_it ? (in_loops & ~own) != 0 : (in_loops & own) != 0;
        if (is_nested) return {};
        if (!over_it) continue;
        for (const NodeId below : nodes_below(graph, std::array{term})) {
            if (graph[below].op == Op::sum) return {};
        }
        sums.push_back(id);
    }
    return sums;
}

NodeId FieldsAsInputs::operator()(Graph& graph, const Node& node, NodeId rebuilt) const {
    if (node.op != Op::element || node.index != array_) return rebuilt;
    auto at = std::find(fields_.begin(), fields_.end(), node.second);
    if (at == fields_.end()) at = fields_.insert(at, node.second);
    return graph.input(first_ + int(at - fields_.begin()));
}

std::optional<SumsApart> sums_apart(const Graph& graph, std::span<const NodeId> roots, int array,
                                    int places) {
    SumsApart apart;
    apart.places = places;
    apart.sums = sums_over(graph, roots, array);
    bool is_summed = false;
    for (const NodeId id : nodes_below(graph, roots)) {
        const Node& node = graph[id];
        is_summed = is_summed || (node.op == Op::sum && node.index == array);
    }
    if (is_summed && apart.sums.empty()) return std::nullopt;

    std::vector<NodeId> bodies;
    for (const NodeId sum : apart.sums) bodies.push_back(graph[sum].children[0]);
    Graph terms;
    terms.fold_exactly();
    const auto of_fields = FieldsAsInputs(apart.fields, array, places);
    apart.terms = schedule(terms, substitute(terms, graph, bodies, of_fields));

    Graph rest;
    rest.fold_exactly();
    int next = places;
    const auto as_input = [&](Graph& to, const Node& node, NodeId rebuilt) {
        const bool is_one = node.op == Op::sum && node.index == array;
        return is_one ? to.input(next++) : rebuilt;
    };
    apart.rest = schedule(rest, substitute(rest, graph, roots, as_input));
    return apart;
}

} // namespace isomotion::formula
