// Formulas with the zeros and signs of another, told without exponentials.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// An expression that is 0, above 0 and below 0 where the root is: without factors that their form
// shows to be above 0, such as exp(u) and cosh(u), and with u - v in place of exp(u) - exp(v).
// x*exp(-x^2) comes to 0 in float32 where x isn't 0. Returns the root where there is nothing to
// leave out.
NodeId same_signs(Graph& graph, NodeId root);

} // namespace isomotion::formula
