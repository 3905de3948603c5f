// Rules for the angles of atan2, which jumps by a turn where a = 0 and b < 0.
#pragma once

#include <optional>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The argument of sin, cos or tan, with angle() for atan2() where a turn more or less is whole
// periods of that function: it has no jump then. sin(3*atan2(y, x) + z) is such a wave;
// sin(atan2(y, x)/2) is none. Arguments of very many summands stay as they are.
NodeId without_cuts(Graph& graph, Op wave, NodeId argument);

// atan2(a, b)/2, if the quotient is a/(sqrt(a^2 + b^2) + b), the tangent of half the angle, which
// has no value at the cut.
std::optional<NodeId> half_angle(Graph& graph, NodeId quotient);

} // namespace isomotion::formula
