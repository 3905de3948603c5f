// Expressions whose parts stay within what floats hold.
#pragma once

#include <span>
#include <vector>

#include "formula/graph/graph.h"
#include "formula/graph/purpose.h"

namespace isomotion::formula {

// An expression equal to another on paper, in which sums are taken from their largest term:
// logarithms of sums of exponentials (log_sums.h) from the largest exponent m, powers of sums of
// powers (power_sums.h) from the largest base m. As written, all terms would be 0 or cut off in
// floats, and F flat there.
//
// Sums over elements stay as they are, and so does what is made for each element. Over boxes m is
// an interval that counts twice, so logarithms stay as written there, and so does all that is in a
// sum over elements.
//
//     const InRange in_range(graph, root, Purpose::numbers);
//     const NodeId slope = differentiate_inputs(graph, in_range.root(), direction);
//     const std::vector<NodeId> both = in_range.complete(std::array{in_range.root(), slope});
class InRange {
public:
    InRange(Graph& graph, NodeId root, Purpose purpose);

    // The expression, with an input of its own for each m. What it comes to at a point does not
    // depend on m, so derivatives take m for a constant. Bounds have no derivatives: they know that
    // m is the largest.
    NodeId root() const { return root_; }

    // Expressions made of root(), with m in the place of these inputs.
    std::vector<NodeId> complete(std::span<const NodeId> roots) const;

private:
    Graph& graph_;
    NodeId root_;
    std::vector<NodeId> largest_; // m, complete
};

// The expression for values over boxes.
NodeId bounds_in_range(Graph& graph, NodeId root);

} // namespace isomotion::formula
