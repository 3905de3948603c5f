// Whether a formula squares an expression that is not of the first degree in the coordinates.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Where such an expression is 0, F may come much closer to 0 than its samples show, without
// reaching it.
bool has_squares(const Graph& graph, NodeId root);

} // namespace isomotion::formula
