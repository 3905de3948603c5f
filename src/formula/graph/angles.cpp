#include "formula/graph/angles.h"

#include <cmath>
#include <limits>

namespace isomotion::formula {
namespace {

constexpr int deepest = 16; // that arguments are looked at

double exact_product(double a, double b) {
    const double product = a * b;
    return std::fma(a, b, -product) == 0 ? product : std::numeric_limits<double>::quiet_NaN();
}
double exact_quotient(double a, double b) {
    const double quotient = a / b;
    return std::fma(quotient, b, -a) == 0 ? quotient : std::numeric_limits<double>::quiet_NaN();
}

// `periods`: by how many periods of the wave its argument changes where this node changes by a
// turn.
NodeId without_cuts(Graph& g, NodeId id, double periods, int depth) {
    if (depth == 0) return id;
    const Node node = g[id]; // a copy: the graph grows
    const auto [a, b, c, d] = node.children;
    const auto of = [&](NodeId child, double its) {
        return without_cuts(g, child, its, depth - 1);
    };
    switch (node.op) {
    case Op::atan2:
        return periods == std::floor(periods) ? g.binary(Op::angle, a, b) : id;
    case Op::negate: {
        const NodeId now = of(a, periods);
        return now == a ? id : g.unary(Op::negate, now);
    }
    case Op::add:
    case Op::subtract: {
        const NodeId left = of(a, periods), right = of(b, periods);
        return left == a && right == b ? id : g.binary(node.op, left, right);
    }
    case Op::multiply: { // a constant comes first
        if (!g.is_constant(a)) return id;
        const NodeId now = of(b, exact_product(periods, g[a].value));
        return now == b ? id : g.multiply(a, now);
    }
    case Op::divide: {
        if (!g.is_constant(b)) return id;
        const NodeId now = of(a, exact_quotient(periods, g[b].value));
        return now == a ? id : g.divide(now, b);
    }
    default:
        return id;
    }
}

bool is_square_of(const Graph& g, NodeId square, NodeId of) {
    const Node& node = g[square];
    return node.op == Op::multiply && node.children[0] == of && node.children[1] == of;
}

bool is_distance(const Graph& g, NodeId root, NodeId a, NodeId b) {
    if (g[root].op != Op::sqrt) return false;
    const Node& sum = g[g[root].children[0]];
    if (sum.op != Op::add) return false;
    const auto [first, second, c, d] = sum.children;
    return (is_square_of(g, first, a) && is_square_of(g, second, b)) ||
           (is_square_of(g, first, b) && is_square_of(g, second, a));
}

} // namespace

NodeId without_cuts(Graph& g, Op wave, NodeId argument) {
    return without_cuts(g, argument, wave == Op::tan ? 2 : 1, deepest);
}

std::optional<NodeId> half_angle(Graph& g, NodeId quotient) {
    const Node node = g[quotient];
    if (node.op != Op::divide || g[node.children[1]].op != Op::add) return std::nullopt;
    const NodeId a = node.children[0];
    const auto [first, second, c, d] = g[node.children[1]].children;
    for (const auto& [root, b] : {std::pair(first, second), std::pair(second, first)}) {
        if (is_distance(g, root, a, b))
            return g.multiply(g.constant(0.5), g.binary(Op::atan2, a, b));
    }
    return std::nullopt;
}

} // namespace isomotion::formula
