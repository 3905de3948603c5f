#include "formula/graph/recentred.h"

#include <cmath>
#include <optional>

#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

// An expression as a sum of one without a constant and a constant.
struct Apart {
    std::optional<NodeId> rest; // none: the constant alone
    double constant = 0;
};

NodeId joined(Graph& g, const Apart& sum) {
    if (!sum.rest) return g.constant(sum.constant);
    return sum.constant == 0 ? *sum.rest : g.add(*sum.rest, g.constant(sum.constant));
}

// The constants of a sum that was gathered are one, at its top.
Apart apart(Graph& g, NodeId id) {
    const Node node = g[id]; // a copy: the graph grows
    if (node.op == Op::constant) return {{}, node.value};
    const auto [a, b] = std::array{node.children[0], node.children[1]};
    if (node.op == Op::add && g.is_constant(a)) return {b, g[a].value};
    if (node.op == Op::add && g.is_constant(b)) return {a, g[b].value};
    if (node.op == Op::subtract && g.is_constant(b)) return {a, -g[b].value};
    if (node.op == Op::subtract && g.is_constant(a)) return {g.unary(Op::negate, b), g[a].value};
    return {id, 0};
}

// a - n 2 pi, n a whole number, in twice the digits of a double.
double without_turns(double a) {
    constexpr double turn = 0x1.921fb54442d18p+2, rest_of_turn = 0x1.1a62633145c07p-52;
    const double n = std::round(a / turn);
    return std::fma(-n, rest_of_turn, std::fma(-n, turn, a));
}

// Operations on sums, made of their parts. None for those that no constant passes.
std::optional<NodeId> gathered(Graph& g, const Node& node) {
    const Apart a = apart(g, node.children[0]);
    const Apart b = node.arity > 1 ? apart(g, node.children[1]) : Apart{};
    if (a.constant == 0 && (b.constant == 0 || !b.rest)) return {};
    const auto with_rest = [&](Op op, double constant) {
        if (a.rest && b.rest) return joined(g, {g.binary(op, *a.rest, *b.rest), constant});
        if (a.rest || op == Op::add) return joined(g, {a.rest ? a.rest : b.rest, constant});
        return g.subtract(g.constant(constant), *b.rest);
    };
    const auto without_steps = [&](double step) { return joined(g, {a.rest, a.constant - step}); };
    switch (node.op) {
    case Op::negate:
        return joined(g, {g.unary(Op::negate, *a.rest), -a.constant});
    case Op::add:
        return with_rest(Op::add, a.constant + b.constant);
    case Op::subtract:
        return with_rest(Op::subtract, a.constant - b.constant);
    case Op::multiply:
        if (a.rest && !b.rest)
            return joined(g, {g.multiply(*a.rest, node.children[1]), a.constant * b.constant});
        if (b.rest && !a.rest)
            return joined(g, {g.multiply(node.children[0], *b.rest), a.constant * b.constant});
        return {};
    case Op::divide:
        if (!a.rest || b.rest) return {};
        return joined(g, {g.divide(*a.rest, node.children[1]), a.constant / b.constant});
    case Op::sin:
    case Op::cos:
    case Op::tan:
        return g.unary(node.op, without_steps(a.constant - without_turns(a.constant)));
    case Op::floor: {
        const double whole = std::floor(a.constant);
        return joined(g, {g.unary(Op::floor, without_steps(whole)), whole});
    }
    default:
        return {};
    }
}

} // namespace

NodeId recentred(Graph& graph, NodeId root, const std::array<double, 3>& origin) {
    if (origin == std::array<double, 3>{}) return root;
    const Graph from = graph;
    const auto replacement = [&](Graph& to, const Node& node, NodeId rebuilt) {
        if (node.op == Op::input && std::size_t(node.index) < origin.size())
            return to.add(rebuilt, to.constant(origin[std::size_t(node.index)]));
        const Node now = to[rebuilt]; // a copy: the graph grows
        const bool is_numeric = now.arity == 1 || now.arity == 2;
        if (!is_numeric || is_over_elements(now.op)) return rebuilt;
        return gathered(to, now).value_or(rebuilt);
    };
    return substitute(graph, from, std::array{root}, replacement).front();
}

} // namespace isomotion::formula
