// Quotients by powers as powers of a reciprocal.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::topology {

// The expression with a/s^n as a (1/s)^n, wherever a doesn't depend on inputs and s is a sum with a
// constant above 0. Slopes of the latter have powers of 1/s alone, which intervals enclose well;
// those of the former have s above and s^n below. For enclosures over boxes: where s may come to 0
// after all, values and slopes are the entire line.
formula::NodeId with_reciprocals(formula::Graph& graph, formula::NodeId root);

} // namespace isomotion::topology
