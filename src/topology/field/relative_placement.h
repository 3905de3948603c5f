// Where one surface is as seen from another, as expressions of time.
#pragma once

#include <array>

#include "animation/rules.h"
#include "formula/graph/graph.h"
#include "scene/scene.h"

namespace isomotion::topology {

// The expressions of a placement's tracks, see scene::Placement.
struct PlacementNodes {
    std::array<formula::NodeId, 3> translate{}, rotate{};
    formula::NodeId scale{};
};

PlacementNodes placement_nodes(const scene::Placement& placement, formula::Graph& graph,
                               animation::Rules& rules);

// The inputs x, y, z, which are coordinates of a surface placed by `from`, as coordinates of one
// placed by `to`. Placements, and parts of them, that are equal leave nothing behind.
std::array<formula::NodeId, 3> coordinates_in(formula::Graph& graph, const PlacementNodes& from,
                                              const PlacementNodes& to);

} // namespace isomotion::topology
