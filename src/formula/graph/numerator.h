// Formulas with poles, as quotients of two expressions.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Above 0 over boxes where the root has no zero although it may have a pole, at least 0 over all
// other boxes. y - x*tan(z) is (y*cos(z) - x*sin(z))/cos(z): where the numerator keeps off 0 the
// root has no zero, whatever its denominator does. Both operands of min and max must keep off 0.
// The constant 0 for a root without quotients, and for a large one, of which bounds would tell
// nothing.
NodeId without_zero(Graph& graph, NodeId root);

} // namespace isomotion::formula
