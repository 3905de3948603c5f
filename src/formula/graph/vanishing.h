// Tells where an expression is exactly 0 over a box: kernels beyond their support, and sums of
// them.
//
// Intervals of such sums are not exactly 0, since each operation rounds outwards.
#pragma once

#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// For each node up to `root`, an expression that is above 0 over boxes where the node is 0
// everywhere, as far as its operations show, and at least 0 over all other boxes.
std::vector<NodeId> vanishing(Graph& graph, NodeId root);

} // namespace isomotion::formula
