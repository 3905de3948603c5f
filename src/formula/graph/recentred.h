// Expressions of coordinates that are counted from another point than the origin.
#pragma once

#include <array>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// What `root` says of p + origin, as an expression of p. Constants are gathered, so that
// (x - 500000)^2 from 500000 on is x^2: sums add them up, products and quotients by a number pass
// them on, and whole turns of sin, cos and tan and whole steps of floor are left out. What remains
// of a turn is rounded to a double.
NodeId recentred(Graph& graph, NodeId root, const std::array<double, 3>& origin);

} // namespace isomotion::formula
