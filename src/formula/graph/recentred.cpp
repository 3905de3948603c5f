#include "formula/graph/recentred.h"

#include <cmath>
#include <optional>

#include "formula/graph/substitute.h"
#include "formula/interval/double_double.h"

namespace isomotion::formula {
namespace {

// Constants keep 106 bits, so that what is gathered is what the formula says.
using Constant = DoubleDouble<double>;

bool is_zero(const Constant& c) { return c.hi == 0 && c.lo == 0; }

Constant quotient(const Constant& a, double b) {
    const double first = a.hi / b;
    const Constant rest = a - exactly(first) * exactly(b);
    return exactly(first) + exactly(rest.hi / b);
}

// An expression as a sum of one without a constant and a constant.
struct Apart {
    std::optional<NodeId> rest; // none: the constant alone
    Constant constant{};
};

NodeId joined(Graph& g, const Apart& sum) {
    NodeId all = sum.rest ? *sum.rest : g.constant(sum.constant.hi);
    if (sum.rest && sum.constant.hi != 0) all = g.add(all, g.constant(sum.constant.hi));
    return sum.constant.lo == 0 ? all : g.add(all, g.constant(sum.constant.lo));
}

// The constants of a sum that was gathered are at its top.
Apart apart(Graph& g, NodeId id) {
    Constant constant{};
    while (true) {
        const Node node = g[id]; // a copy: the graph grows
        const auto [a, b] = std::array{node.children[0], node.children[1]};
        if (node.op == Op::constant) return {{}, constant + exactly(node.value)};
        if (node.op == Op::subtract && g.is_constant(a))
            return {g.unary(Op::negate, b), constant + exactly(g[a].value)};
        const bool is_sum = node.op == Op::add || node.op == Op::subtract;
        if (node.op == Op::add && g.is_constant(a)) {
            constant = constant + exactly(g[a].value);
            id = b;
        } else if (is_sum && g.is_constant(b)) {
            constant = constant + exactly(node.op == Op::add ? g[b].value : -g[b].value);
            id = a;
        } else {
            return {id, constant};
        }
    }
}

// a - n 2 pi, n a whole number.
Constant without_turns(const Constant& a) {
    constexpr Constant turn{0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52};
    return a - exactly(std::round(a.hi / turn.hi)) * turn;
}

// Operations on sums, made of their parts. None for those that no constant passes.
std::optional<NodeId> gathered(Graph& g, const Node& node) {
    constexpr double farthest = 0x1p50; // beyond it, turns and steps are not told apart
    const Apart a = apart(g, node.children[0]);
    const Apart b = node.arity > 1 ? apart(g, node.children[1]) : Apart{};
    if (is_zero(a.constant) && (is_zero(b.constant) || !b.rest)) return {};
    const auto with_rest = [&](Op op, const Constant& constant) {
        if (a.rest && b.rest) return joined(g, {g.binary(op, *a.rest, *b.rest), constant});
        if (a.rest || op == Op::add) return joined(g, {a.rest ? a.rest : b.rest, constant});
        return joined(g, {b.rest ? std::optional(g.unary(Op::negate, *b.rest)) : b.rest, constant});
    };
    switch (node.op) {
    case Op::negate:
        if (!a.rest) return {};
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
        return joined(g,
                      {g.divide(*a.rest, node.children[1]), quotient(a.constant, b.constant.hi)});
    case Op::sin:
    case Op::cos:
    case Op::tan:
        if (!(std::abs(a.constant.hi) < farthest)) return {};
        return g.unary(node.op, joined(g, {a.rest, without_turns(a.constant)}));
    case Op::floor: {
        if (!(std::abs(a.constant.hi) < farthest)) return {};
        const Constant whole = exactly(std::floor(a.constant.hi));
        const NodeId rest = joined(g, {a.rest, a.constant - whole});
        return joined(g, {g.unary(Op::floor, rest), whole});
    }
    default:
        return {};
    }
}

// The number as it is written, or none if the node is no far number.
std::optional<NodeId> counted(Graph& g, const Node& node, const Origin& origin) {
    if (node.op == Op::input && std::size_t(node.index) < origin.point.size())
        return g.add(g.input(node.index), g.constant(origin.point[std::size_t(node.index)]));
    for (const FarNumber& number : origin.numbers) {
        const bool is_it = number.is_parameter
                               ? node.op == Op::parameter && node.index == number.index
                               : node.op == Op::element && node.index == number.index &&
                                     node.second == number.field;
        if (!is_it) continue;
        const NodeId element = g.element(number.near_array, number.near_field);
        const NodeId near = number.is_parameter ? g.sum(number.near_array, element) : element;
        return g.add(near, g.constant(number.from));
    }
    return {};
}

} // namespace

NodeId recentred(Graph& graph, NodeId root, const Origin& origin) {
    if (origin.point == std::array<double, 3>{} && origin.numbers.empty()) return root;
    const Graph from = graph;
    const auto replacement = [&](Graph& to, const Node& node, NodeId rebuilt) {
        if (const auto number = counted(to, node, origin)) return *number;
        const Node now = to[rebuilt]; // a copy: the graph grows
        const bool is_numeric = now.arity == 1 || now.arity == 2;
        if (!is_numeric || is_over_elements(now.op)) return rebuilt;
        return gathered(to, now).value_or(rebuilt);
    };
    return substitute(graph, from, std::array{root}, replacement).front();
}

} // namespace isomotion::formula
