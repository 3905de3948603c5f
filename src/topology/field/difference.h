// What a choice compares.
#pragma once

#include <optional>

#include "formula/graph/graph.h"

namespace isomotion::topology {

// min, max and abs are made of |first - second| and smooth parts.
struct Difference {
    formula::NodeId first = 0, second = 0;
    bool operator==(const Difference&) const = default;
};

// None for other operations. |a| is that of a and 0.
inline std::optional<Difference> difference(formula::Graph& graph, const formula::Node& node) {
    using formula::Op;
    if (node.op == Op::min || node.op == Op::max)
        return Difference{node.children[0], node.children[1]};
    if (node.op != Op::abs) return std::nullopt;
    const formula::Node inner = graph[node.children[0]];
    if (inner.op == Op::subtract) return Difference{inner.children[0], inner.children[1]};
    return Difference{node.children[0], graph.constant(0)};
}

// Whether they have the same size.
inline bool is_the_same(const Difference& a, const Difference& b) {
    return a == b || a == Difference{b.second, b.first};
}

} // namespace isomotion::topology
