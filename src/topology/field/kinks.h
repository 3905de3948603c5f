// Where F or its gradient jumps. Elsewhere slopes of slopes enclose the second derivatives.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::topology {

// A term to add to slopes of slopes of `root`: 0 over a box without a kink of min, max and select
// and without a jump of floor, sign and random, without bounds over others. Slopes over a box hold
// across these, but slopes of those slopes don't. At the ends of sqrt, asin and acos nothing need
// be added: slopes of slopes are quotients 0/0 there, which have no bounds.
formula::NodeId kinks(formula::Graph& graph, formula::NodeId root);

} // namespace isomotion::topology
