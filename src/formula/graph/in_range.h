// Expressions whose parts stay within what floats hold.
#pragma once

#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// An expression equal to another on paper, in which sums are divided by their largest term m:
// logarithms of sums of exponentials (log_sums.h) and powers of sums of powers (power_sums.h). As
// written, all terms would be 0 or cut off in floats, and F flat there. For values: in intervals m
// would count several times. Sums over elements, and what is made for each element, stay as they
// are.
//
//     const InRange in_range(graph, root);
//     const NodeId slope = differentiate_inputs(graph, in_range.root(), direction);
//     const std::vector<NodeId> both = in_range.complete(std::array{in_range.root(), slope});
class InRange {
public:
    InRange(Graph& graph, NodeId root);

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

} // namespace isomotion::formula
