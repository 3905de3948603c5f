// Building blocks of decorations (continuity.h).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

#include "formula/graph/conditions.h"
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

// The sum of `decoration` over all nodes below the root, but for what a choice leaves out.
template<class Decoration> NodeId all_below(Graph& g, NodeId root, Decoration&& decoration) {
    const std::vector<NodeId> nodes = nodes_below(g, std::array{root});
    if (std::ranges::none_of(nodes, [&](NodeId id) { return is_choice(g[id]); })) {
        NodeId all = g.constant(0);
        for (const NodeId id : nodes) all = g.add(all, of_any_element(g, decoration(g, id)));
        return all;
    }
    std::vector<NodeId> below(std::size_t(root) + 1,
                              g.constant(0)); // of each node and its operands
    for (const NodeId id : nodes) {
        const Node node = g[id]; // a copy: the graph grows
        const auto& of = node.children;
        NodeId all = decoration(g, id);
        if (is_choice(node)) {
            all = g.add(all, g.add(below[of[0]], below[of[1]]));
            all = g.add(all, g.select(of[0], of[1], below[of[2]], below[of[3]]));
        } else {
            for (std::size_t k = 0; k < node.arity; ++k) all = g.add(all, below[of[k]]);
        }
        const bool is_loop = is_over_elements(node.op) && (g[all].arrays >> node.index & 1u) != 0;
        below[id] = is_loop ? g.sum(node.index, all) : all;
    }
    return of_any_element(g, below[root]);
}

} // namespace isomotion::formula
