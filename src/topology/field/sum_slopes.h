// What Taylor's formula needs of the terms of sums.
#pragma once

#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::topology {

// Expressions of one element, like the body of the sum.
struct SumSlopes {
    formula::NodeId sum{};
    std::vector<formula::NodeId> first; // by each unknown
    // The slopes by unknowns i and j, for each i each j <= i. Only sums that are in F itself have
    // them.
    std::vector<formula::NodeId> second;
    // 0 over boxes where the body has a value everywhere and no kink, so that slopes that are
    // bounded are those of Taylor's formula; else the entire line (formula/graph/continuity.h).
    formula::NodeId unless_smooth{};
};

// The slopes of the sums in `jet`, except decorations. `jet` is F and its derivatives by the
// unknowns, all of which are inputs of the graph. Second derivatives are by the first `rows`
// unknowns.
std::vector<SumSlopes> slopes_of_sums(formula::Graph& graph, std::span<const formula::NodeId> jet,
                                      std::size_t rows);

} // namespace isomotion::topology
