// Building blocks of decorations (continuity.h).
#pragma once

#include <array>
#include <bit>
#include <limits>

#include "formula/graph/substitute.h"

namespace isomotion::formula {

inline NodeId entire(Graph& g) { return g.constant(std::numeric_limits<double>::quiet_NaN()); }

// 0 where a node that takes discrete values has only one of them. The test is that an interval that
// isn't a point is neither less than itself nor not.
inline NodeId unless_one_value(Graph& g, NodeId node) {
    return g.select(node, node, entire(g), g.constant(0));
}

// 0 where a is above b everywhere.
inline NodeId unless_above(Graph& g, NodeId a, NodeId b) {
    return g.select(b, a, g.constant(0), entire(g));
}

// 0 where a node is bounded. An interval with an upper bound is below the point at infinity, which
// begins at the largest number.
inline NodeId unless_bounded(Graph& g, NodeId node) {
    return unless_above(g, g.constant(std::numeric_limits<double>::infinity()),
                        g.unary(Op::abs, node));
}

// Decoration of an operation that finds the least element: 0 where the same element is the least
// everywhere.
inline NodeId unless_one_is_least(Graph& g, const Node& node) {
    return unless_one_value(g, g.which(node.index, node.children[0]));
}

// The decoration for all elements of each array that it depends on.
inline NodeId of_any_element(Graph& g, NodeId decoration) {
    while (const std::uint32_t arrays = g[decoration].arrays)
        decoration = g.sum(std::countr_zero(arrays), decoration);
    return decoration;
}

// The sum of `decoration` over all nodes below the root.
template<class Decoration> NodeId all_below(Graph& g, NodeId root, Decoration&& decoration) {
    NodeId all = g.constant(0);
    for (const NodeId id : nodes_below(g, std::array{root}))
        all = g.add(all, of_any_element(g, decoration(g, id)));
    return all;
}

} // namespace isomotion::formula
