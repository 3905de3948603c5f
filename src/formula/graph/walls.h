// Jumps drawn as walls of the solid F < 0. Across a wall F changes its sign without being 0, and
// its gradient there doesn't give the wall's normal.
#pragma once

#include <array>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The gradient of `root`. But closer than `distance` to a place where an operation may jump or has
// a pole it is a normal of that place, towards larger F. The place is where the jump happens: u = 0
// for sign(u), a whole u for floor(u), a = b for a selection by a < b, b = 0 for a / b. If there
// are several places, the nearest counts.
std::array<NodeId, 3> wall_gradient(Graph& graph, NodeId root, double distance);

} // namespace isomotion::formula
