#include "formula/graph/same_signs.h"

#include <cmath>
#include <optional>

namespace isomotion::formula {
namespace {

bool is_constant_from(const Graph& g, NodeId id, double least) {
    return g.is_constant(id) && g[id].value >= least && std::isfinite(g[id].value);
}

// Whether it is above 0 everywhere, though it may come to 0 in floats.
bool is_positive(const Graph& g, NodeId id) {
    const Node& node = g[id];
    if (node.may_have_gaps) return false;
    const auto [a, b, c, d] = node.children;
    switch (node.op) {
    case Op::exp:
    case Op::cosh:
        return true;
    case Op::constant:
        return is_constant_from(g, id, 0) && node.value > 0;
    case Op::multiply:
    case Op::divide:
        return is_positive(g, a) && is_positive(g, b);
    case Op::add:
        return (is_positive(g, a) && is_positive(g, b)) ||
               (is_constant_from(g, a, 1) && g[b].op == Op::tanh) ||
               (is_constant_from(g, b, 1) && g[a].op == Op::tanh);
    case Op::subtract:
        return is_constant_from(g, a, 1) && g[b].op == Op::tanh;
    default:
        return false;
    }
}

bool may_be_left_out(const Graph& g, NodeId factor) {
    return !g.is_constant(factor) && is_positive(g, factor);
}

// u of an expression that is exp(u).
std::optional<NodeId> exponent(Graph& g, NodeId id) {
    const Node node = g[id];
    if (node.may_have_gaps) return {};
    if (node.op == Op::exp) return node.children[0];
    if (node.op == Op::constant && is_positive(g, id)) return g.constant(std::log(node.value));
    if (node.op != Op::multiply) return {};
    const auto a = exponent(g, node.children[0]), b = exponent(g, node.children[1]);
    if (!a || !b) return {};
    return g.add(*a, *b);
}

// What differs as these two do, if both are the same growing function of something.
std::optional<NodeId> difference_of_arguments(Graph& g, NodeId a, NodeId b) {
    if (g.is_constant(a) || g.is_constant(b)) return {};
    if (g[a].op == Op::tanh && g[b].op == Op::tanh && !g[a].may_have_gaps && !g[b].may_have_gaps)
        return g.subtract(g[a].children[0], g[b].children[0]);
    const auto u = exponent(g, a), v = exponent(g, b);
    if (!u || !v) return {};
    return g.subtract(*u, *v);
}

NodeId without_factors(Graph& g, NodeId id) {
    const Node node = g[id]; // the graph grows
    const auto [a, b, c, d] = node.children;
    switch (node.op) {
    case Op::negate:
        return g.unary(Op::negate, without_factors(g, a));
    case Op::multiply:
        if (may_be_left_out(g, a)) return without_factors(g, b);
        if (may_be_left_out(g, b)) return without_factors(g, a);
        return g.multiply(without_factors(g, a), without_factors(g, b));
    case Op::divide:
        if (may_be_left_out(g, b)) return without_factors(g, a);
        return g.divide(without_factors(g, a), b);
    case Op::subtract:
        return difference_of_arguments(g, a, b).value_or(id);
    default:
        return id;
    }
}

} // namespace

NodeId same_signs(Graph& graph, NodeId root) {
    const NodeId found = without_factors(graph, root);
    return graph.is_constant(found) ? root : found; // a formula without a zero stays as it is
}

} // namespace isomotion::formula
