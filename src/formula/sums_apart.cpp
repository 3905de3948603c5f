#include "formula/sums_apart.h"

#include <algorithm>
#include <array>

#include "formula/graph/substitute.h"

namespace isomotion::formula {

std::vector<NodeId> sums_over(const Graph& graph, std::span<const NodeId> roots, int array) {
    std::vector<NodeId> sums;
    for (const NodeId id : nodes_below(graph, roots)) {
        const Node& node = graph[id];
        if (!is_over_elements(node.op)) continue;
        const std::span<const NodeId> terms(node.children.data(), node.arity);
        const bool over_it = node.index == array;
        const std::uint32_t own = 1u << array;
        std::uint32_t in_loops = node.arrays;
        for (const NodeId term : terms) in_loops |= graph[term].arrays;
        const bool is_nested = over_it ? (in_loops & ~own) != 0 : (in_loops & own) != 0;
        if (is_nested) return {};
        if (!over_it) continue;
        for (const NodeId below : nodes_below(graph, terms)) {
            if (is_over_elements(graph[below].op)) return {};
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
    const std::vector<NodeId> sums = sums_over(graph, roots, array);
    bool is_summed = false;
    for (const NodeId id : nodes_below(graph, roots)) {
        const Node& node = graph[id];
        is_summed = is_summed || (is_over_elements(node.op) && node.index == array);
    }
    if (is_summed && sums.empty()) return std::nullopt;

    std::vector<NodeId> bodies;
    for (const NodeId sum : sums) {
        const Node& node = graph[sum];
        apart.sums.push_back({sum, node.op, int(bodies.size())});
        bodies.insert(bodies.end(), node.children.begin(), node.children.begin() + node.arity);
    }
    Graph terms;
    terms.fold_exactly();
    const auto of_fields = FieldsAsInputs(apart.fields, array, places);
    apart.terms = schedule(terms, substitute(terms, graph, bodies, of_fields));

    Graph rest;
    rest.fold_exactly();
    int next = places;
    const auto as_input = [&](Graph& to, const Node& node, NodeId rebuilt) {
        const bool is_one = is_over_elements(node.op) && node.index == array;
        return is_one ? to.input(next++) : rebuilt;
    };
    apart.rest = schedule(rest, substitute(rest, graph, roots, as_input));
    return apart;
}

} // namespace isomotion::formula
