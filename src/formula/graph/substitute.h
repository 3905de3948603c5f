// Copies of expressions with some of their parts replaced.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The replacement of a node. `rebuilt` is the node remade in `to` from the replacements of its
// children (a leaf: the same leaf). Return it, or another node.
using Replacement = std::function<NodeId(Graph& to, const Node& node, NodeId rebuilt)>;

// The node with other children, made in `to`.
NodeId remade(Graph& to, const Node& node, const std::array<NodeId, 4>& children,
              int first_array = 0);

// The expressions `roots` of `from`, remade in `to`, which may be `from` itself. Array k of `from`
// becomes array `first_array` + k of `to`.
std::vector<NodeId> substitute(Graph& to, const Graph& from, std::span<const NodeId> roots,
                               const Replacement& replacement, int first_array = 0);

// An expression remade in its own graph. Sums over elements stay, with all that is below them.
NodeId substitute_outside_sums(Graph& graph, NodeId root, const Replacement& replacement);

// All nodes below the roots, including the roots, in ascending order: children before parents.
std::vector<NodeId> nodes_below(const Graph& graph, std::span<const NodeId> roots);

} // namespace isomotion::formula
