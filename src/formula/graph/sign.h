// Signs that the form of an expression shows.
#pragma once

#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Whether the expression, looked at down to this depth, shows that its values are 0 or more,
// wherever it has one.
bool is_never_negative(const Graph& graph, NodeId id, int depth = 12);

// For each node up to the root, whether its form shows that it is above 0 everywhere, though it may
// come to 0 in floats: exp(u), cosh(u), 1 + tanh(u), sums and products of such.
std::vector<bool> positives(const Graph& graph, NodeId root);

// Whether it shows a constant beside a wave as high: 0 or more but for rounding.
bool may_round_below_0(const Graph& graph, NodeId id);

} // namespace isomotion::formula
