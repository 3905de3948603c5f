// Where an expression isn't smooth: decorations (continuity.h) of the kinds of places that methods
// have to know of.
#pragma once

#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// One for each operation that may have such places, 0 over boxes that hold none of them, and the
// entire line over those that may.
struct Roughness {
    // Slopes jump or have no bound: abs, min, max, roots and real powers at 0.
    std::vector<NodeId> kinks;
    std::vector<NodeId> jumps; // floor, sign, the branches of a selection
    std::vector<NodeId> poles; // quotients, negative powers, log, tan; places without a value
};

// A kink that is raised to the third or a higher power (max(0, u)^3) is none: second derivatives
// are continuous there. Nor are exp, sinh and cosh where they are cut off, at 10^30.
Roughness roughness(Graph& graph, NodeId root);

// All of them in one.
NodeId anywhere(Graph& graph, const Roughness& roughness);

} // namespace isomotion::formula
