#include "formula/graph/numerator.h"

#include <array>
#include <optional>
#include <vector>

#include "formula/graph/substitute.h"
#include "formula/graph/term.h"

namespace isomotion::formula {
namespace {

// Of larger formulas bounds would tell nothing.
constexpr std::size_t most_nodes = 1000, most_quotients = 16;

// over / under; without `under` it has no poles of its own.
struct Quotient {
    Term over;
    std::optional<Term> under{};
};

Term times(Term a, const std::optional<Term>& b) { return b ? a * *b : a; }

std::optional<Term> product(const std::optional<Term>& a, const std::optional<Term>& b) {
    return a ? std::optional(times(*a, b)) : b;
}

Quotient sum(Op op, const Quotient& a, const Quotient& b) {
    return {times(a.over, b.under).with(op, times(b.over, a.under)), product(a.under, b.under)};
}

Quotient quotient(Graph& g, NodeId id, const std::vector<Quotient>& known) {
    const Node node = g[id]; // a copy: the graph grows
    const Term itself{&g, id};
    if (node.arity == 0) return {itself};
    const Quotient &a = known[node.children[0]], &b = known[node.children[node.arity > 1 ? 1 : 0]];
    switch (node.op) {
    case Op::negate:
        return {-a.over, a.under};
    case Op::abs: {
        const auto size = [](Term part) { return part.of(Op::abs); };
        return {size(a.over), a.under ? std::optional(size(*a.under)) : std::nullopt};
    }
    case Op::add:
    case Op::subtract:
        return sum(node.op, a, b);
    case Op::multiply:
        return {a.over * b.over, product(a.under, b.under)};
    case Op::divide:
        if (g.is_constant(node.children[1])) return {a.over / b.over, a.under};
        return {times(a.over, b.under), product(a.under, b.over)};
    case Op::tan: {
        const Term of{&g, node.children[0]};
        return {of.of(Op::sin), of.of(Op::cos)};
    }
    case Op::power: {
        const Term base{&g, node.children[0]};
        // A negative power of a pole is 0.
        const bool is_pole = g.is_constant(node.children[1]) && g[node.children[1]].value < 0;
        if (!is_pole || a.under) return {itself};
        return {base.number(1), base.with(Op::power, base.number(-g[node.children[1]].value))};
    }
    default:
        return {itself};
    }
}

NodeId keeps_off_0(Graph& g, NodeId id) {
    const NodeId zero = g.constant(0), one = g.constant(1);
    return g.add(g.select(zero, id, one, zero), g.select(id, zero, one, zero));
}

} // namespace

NodeId without_zero(Graph& g, NodeId root) {
    const std::vector<NodeId> below = nodes_below(g, std::array{root});
    std::size_t quotients = 0;
    for (const NodeId id : below)
        quotients += g[id].op == Op::divide || g[id].op == Op::tan || g[id].op == Op::power;
    if (below.size() > most_nodes || quotients > most_quotients) return g.constant(0);
    std::vector<Quotient> known(std::size_t(root) + 1, Quotient{{&g, root}});
    std::vector<std::optional<NodeId>> nowhere(std::size_t(root) + 1); // of those with poles
    const auto is_nowhere = [&](NodeId id) { return nowhere[id].value_or(keeps_off_0(g, id)); };
    for (const NodeId id : below) {
        known[id] = quotient(g, id, known);
        const Node node = g[id];
        const auto [a, b, c, d] = node.children;
        if (known[id].under) {
            nowhere[id] = keeps_off_0(g, known[id].over.node);
        } else if (node.op == Op::negate || node.op == Op::abs) {
            nowhere[id] = nowhere[a];
        } else if (node.op == Op::min || node.op == Op::max) {
            if (nowhere[a] || nowhere[b]) nowhere[id] = g.multiply(is_nowhere(a), is_nowhere(b));
        }
    }
    return nowhere[root].value_or(g.constant(0));
}

} // namespace isomotion::formula
