// Whether a formula squares something that is not of the first degree in the coordinates.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Where such a factor is 0, F may come much nearer to 0 than its samples tell, and stay off it.
bool has_squares(const Graph& graph, NodeId root);

} // namespace isomotion::formula
