// Quotients by powers as powers of a reciprocal.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::topology {

// The expression with a/s^n as a (1/s)^n, wherever a doesn't depend on inputs and s is a constant
// above 0 plus what is never negative. Slopes of the latter have powers of 1/s alone, which
// intervals enclose well; those of the former have s above and s^n below. Both have equal values.
formula::NodeId with_reciprocals(formula::Graph& graph, formula::NodeId root);

} // namespace isomotion::topology
