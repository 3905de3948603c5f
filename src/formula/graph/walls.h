// Jumps drawn as walls of the solid F < 0: across one F changes its sign without being 0, and its
// gradient there tells nothing of the wall.
#pragma once

#include <array>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The gradient of `root`, but closer than `distance` to a place where an operation may jump or has
// a pole: there it is a normal of that place, towards larger F. It goes by what jumps: u = 0 of
// sign(u), a whole u of floor(u), a = b of a selection by a < b, b = 0 of a / b. The nearest of
// several places counts.
std::array<NodeId, 3> wall_gradient(Graph& graph, NodeId root, double distance);

} // namespace isomotion::formula
