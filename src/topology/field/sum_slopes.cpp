#include "topology/field/sum_slopes.h"

#include <algorithm>

#include "formula/graph/continuity.h"
#include "formula/graph/derivative.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
using formula::Graph;
using formula::NodeId;

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
        SumSlopes& slopes = all.emplace_back();
        slopes.sum = id;
        for (std::size_t k = 0; k < unknowns; ++k) slopes.first.push_back(derivative(body, k));
        for (std::size_t i = 0; i < rows && std::ranges::binary_search(in_value, id); ++i) {
            for (std::size_t j = 0; j <= i; ++j)
                slopes.second.push_back(derivative(slopes.first[j], i));
        }
        slopes.unless_smooth = graph.add(formula::gaps(graph, body), formula::kinks(graph, body));
    }
    return all;
}

} // namespace isomotion::topology
