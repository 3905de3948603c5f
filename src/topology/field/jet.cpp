#include "topology/field/jet.h"

#include "formula/graph/continuity.h"
#include "formula/graph/derivative.h"
#include "topology/field/reciprocals.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::NodeId;
using formula::Slopes;

NodeId derivative(Graph& g, NodeId root, std::size_t by, Slopes slopes) {
    std::vector<NodeId> direction(most_variables, g.constant(0));
    direction[by] = g.constant(1);
    return formula::differentiate_inputs(g, root, direction, slopes);
}

std::vector<NodeId> jet(Graph& g, NodeId field, std::span<const std::size_t> unknowns,
                        std::size_t rows, Slopes first, Slopes second) {
    std::vector<NodeId> nodes{field};
    for (const std::size_t by : unknowns) nodes.push_back(derivative(g, field, by, first));
    for (std::size_t i = 0; i < rows; ++i) {
        for (const std::size_t by : unknowns.subspan(i))
            nodes.push_back(derivative(g, nodes[1 + i], by, second));
    }
    return nodes;
}

} // namespace

std::vector<NodeId> jet_over_boxes(Graph& g, NodeId field, std::span<const std::size_t> unknowns,
                                   std::size_t rows) {
    g.fold_exactly();
    std::vector<NodeId> nodes = jet(g, with_reciprocals(g, field), unknowns, rows,
                                    Slopes::generalized, Slopes::generalized);
    const NodeId gaps = formula::gaps(g, field), kinks = formula::kinks(g, field);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        nodes[k] = g.add(nodes[k], gaps);
        if (k > unknowns.size()) nodes[k] = g.add(nodes[k], kinks);
    }
    return nodes;
}

std::vector<NodeId> jet_at_points(Graph& g, NodeId field, std::span<const std::size_t> unknowns,
                                  std::size_t rows) {
    return jet(g, field, unknowns, rows, Slopes::pointwise, Slopes::pointwise_again);
}

} // namespace isomotion::topology
