// Expressions with others in place of some of their parts.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// What stands for a node: `rebuilt` is the node made anew in `to` from what stands for its children
// (a leaf: the same leaf); return it, or what takes its place.
using Replacement = std::function<NodeId(Graph& to, const Node& node, NodeId rebuilt)>;

// The expressions `roots` of `from`, made anew in `to`, which may be `from` itself.
std::vector<NodeId> substitute(Graph& to, const Graph& from, std::span<const NodeId> roots,
                               const Replacement& replacement);

// Everything below the roots, the roots included, ascending: children before parents.
std::vector<NodeId> nodes_below(const Graph& graph, std::span<const NodeId> roots);

} // namespace isomotion::formula
