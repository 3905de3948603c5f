// Decorations (continuity.h) that tell where an expression isn't smooth, for the kinds of places
// that methods must know.
#pragma once

#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// One decoration for each operation that may have such places: 0 over boxes that hold none of them,
// the entire line over boxes that may.
struct Roughness {
    // Slopes jump or are unbounded: abs, min, max, roots and real powers at 0.
    std::vector<NodeId> kinks;
    std::vector<NodeId> jumps; // floor, sign, atan2, the branches of a selection
    std::vector<NodeId>
        poles; // quotients, angles, negative powers, log, tan; places without a value
};

inline constexpr double smooth_power = 3;

// A kink raised to that or a higher power (max(0, u)^3) doesn't count: second derivatives are
// continuous there. Nor do exp, sinh and cosh where they are cut off, at 10^30.
// Quotients count as smooth over boxes that leave at least a part of the denominator's size.
Roughness roughness(Graph& graph, NodeId root, double least_part);

// For what rays meet of a formula. Poles of (x^2 - y^2)/(x^2 + y^2) are on few rays.
inline constexpr double least_part_of_rays = 0x1p-4;
// For pieces of rays, where that formula turns about its axis: at a sixteenth it lost 12 of 9216
// pixels, at a quarter 4, at a half none, in fewer evaluations.
inline constexpr double least_part_of_pieces = 0x1p-1;

// 0 over boxes that hold none of these places; without an upper bound over all others. It is the
// greatest of all decorations, since shaders take many times as long to add intervals.
NodeId anywhere(Graph& graph, const Roughness& roughness);

} // namespace isomotion::formula
