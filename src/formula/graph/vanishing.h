// Where an expression is exactly 0 over a box: kernels beyond their support, sums of them.
//
// Intervals of such sums are not: each operation rounds outwards.
#pragma once

#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// For each node up to `root`, an expression that is above 0 over boxes where the node is 0 at all
// places, as far as its operations tell, and at least 0 over all others.
std::vector<NodeId> vanishing(Graph& graph, NodeId root);

} // namespace isomotion::formula
