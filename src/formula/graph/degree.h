// The degree of an expression as a polynomial of the coordinates.
#pragma once

#include <optional>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// An upper bound of the degree of `root` in the inputs, for any values of parameters and elements.
// None if the graph does not show a polynomial: quotients, powers with an exponent that isn't a
// whole number, kinks and transcendental functions of an input. Terms that cancel each other still
// count, and degrees above 2^20 are given as 2^20. Whole powers above 24 of inputs have none, as
// graphs clamp their base.
std::optional<int> degree(const Graph& graph, NodeId root);

// The degree of each node up to `root`.
std::vector<std::optional<int>> degrees(const Graph& graph, NodeId root);

} // namespace isomotion::formula
