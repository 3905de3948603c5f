#include "topology/field/sum_slopes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/graph/continuity.h"
#include "formula/graph/derivative.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
using formula::Graph;
using formula::NodeId;

namespace {

// The decoration of the term of one element. Those of continuity.h ask for any element, which for
// each element would take a loop over all.
NodeId of_one_element(Graph& graph, NodeId decoration, int array) {
    const auto without_loop = [&](Graph& g, const formula::Node&, NodeId rebuilt) {
        const formula::Node node = g[rebuilt];
        return node.op == formula::Op::sum && node.index == array ? node.children[0] : rebuilt;
    };
    return formula::substitute(graph, graph, std::array{decoration}, without_loop).front();
}

// Whether the expression is 0 or the entire line everywhere.
bool is_decoration(const Graph& graph, NodeId id) {
    const formula::Node& node = graph[id];
    const auto child = [&](std::size_t k) { return is_decoration(graph, node.children[k]); };
    switch (node.op) {
    case formula::Op::constant:
        return node.value == 0 || std::isnan(node.value);
    case formula::Op::select:
        return child(2) && child(3);
    case formula::Op::add:
        return child(0) && child(1);
    case formula::Op::negate:
    case formula::Op::sum:
        return child(0);
    default:
        return false;
    }
}

} // namespace

std::vector<SumSlopes> slopes_of_sums(Graph& graph, std::span<const NodeId> jet, std::size_t rows) {
    const std::size_t unknowns = jet.size() - 1;
    const auto derivative = [&](NodeId root, std::size_t by) {
        std::vector<NodeId> direction(unknowns, graph.constant(0));
        direction[by] = graph.constant(1);
        return formula::differentiate_inputs(graph, root, direction, formula::Slopes::generalized);
    };
    const std::vector<NodeId> in_value = formula::nodes_below(graph, jet.first(1));
    std::vector<SumSlopes> all;
    for (const NodeId id : formula::nodes_below(graph, jet)) {
        if (graph[id].op != formula::Op::sum) continue;
        const NodeId body = graph[id].children[0];
        if (is_decoration(graph, body)) continue; // Taylor's formula would blur its 0
        SumSlopes& slopes = all.emplace_back();
        slopes.sum = id;
        for (std::size_t k = 0; k < unknowns; ++k) slopes.first.push_back(derivative(body, k));
        for (std::size_t i = 0; i < rows && std::ranges::binary_search(in_value, id); ++i) {
            for (std::size_t j = 0; j <= i; ++j)
                slopes.second.push_back(derivative(slopes.first[j], i));
        }
        const NodeId smooth = graph.add(formula::gaps(graph, body), formula::kinks(graph, body));
        slopes.unless_smooth = of_one_element(graph, smooth, graph[id].index);
    }
    return all;
}

} // namespace isomotion::topology
