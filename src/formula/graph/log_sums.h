// Logarithms of sums of exponentials, as of bodies that are blended by log(exp(-k*a) + exp(-k*b)).
#pragma once

#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// An expression equal to another on paper: log(p*exp(u) + q*exp(v)) as m + log(p*exp(u - m) +
// q*exp(v - m)), where m is the larger of u and v, and p and q are constants other than 0.
// Exponentials alone are 0 below exp(-87) in float32 and cut off at exp(69), so F would be flat
// there, or infinite. For values: in intervals m would count several times. Sums over elements, and
// logarithms for each element, stay as they are.
//
//     const SmallExponents small(graph, root);
//     const NodeId slope = differentiate_inputs(graph, small.root(), direction);
//     const std::vector<NodeId> both = small.complete(std::array{small.root(), slope});
class SmallExponents {
public:
    SmallExponents(Graph& graph, NodeId root);

    // The expression, with an input of its own for each m. What it comes to does not depend on m,
    // so derivatives take m for a constant.
    NodeId root() const { return root_; }

    // Expressions made of root(), with m in the place of these inputs.
    std::vector<NodeId> complete(std::span<const NodeId> roots) const;

private:
    Graph& graph_;
    NodeId root_;
    std::vector<NodeId> largest_; // m, complete
};

// Whether there is a logarithm of exponentials that are summed over elements. Such a sum stays as
// it is, so it may come to 0 in floats, where its logarithm jumps from -87 to where it is cut off.
bool has_fading_logs(const Graph& graph, NodeId root);

} // namespace isomotion::formula
