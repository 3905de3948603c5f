#include "topology/field/sum_slopes.h"

#include <algorithm>
#include <array>

#include "formula/graph/continuity.h"
#include "formula/graph/decoration.h"
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
    const NodeId entire = formula::entire(graph);
    for (const NodeId id : formula::nodes_below(graph, jet)) {
        if (graph[id].op != formula::Op::sum) continue;
        const NodeId body = graph[id].children[0];
        // Decorations are 0 or the entire line, and Taylor's formula would blur their 0.
        if (std::ranges::binary_search(formula::nodes_below(graph, std::array{body}), entire))
            continue;
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
