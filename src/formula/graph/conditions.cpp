#include "formula/graph/conditions.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace isomotion::formula {
namespace {

// a < b ? then : otherwise
NodeId choice(Graph& g, NodeId a, NodeId b, NodeId then, NodeId otherwise) {
    const auto compares_them = [&](NodeId id) {
        return is_choice(g[id]) && g[id].children[0] == a && g[id].children[1] == b;
    };
    if (compares_them(then)) then = g[then].children[2];
    if (compares_them(otherwise)) otherwise = g[otherwise].children[3];
    if (then == a && otherwise == b) return g.binary(Op::min, a, b);
    if (then == b && otherwise == a) return g.binary(Op::max, a, b);
    const auto is_negative_of = [&](NodeId one, NodeId other) {
        return g[one].op == Op::negate && g[one].children[0] == other;
    };
    const bool by_sign = (g.is_constant(b, 0) && otherwise == a && is_negative_of(then, a)) ||
                         (g.is_constant(a, 0) && then == b && is_negative_of(otherwise, b));
    if (by_sign) return g.unary(Op::abs, g.is_constant(b, 0) ? a : b);
    return g.select(a, b, then, otherwise, Op::select);
}

// The choices that lead from a node to what it may be, and these ends, in ascending order: what is
// chosen before what chooses. Chains of conditions are long, so nothing recurses.
std::vector<NodeId> choices_below(const Graph& g, NodeId id) {
    std::vector<NodeId> all, open{id};
    std::unordered_set<NodeId> seen;
    while (!open.empty()) {
        const NodeId now = open.back();
        open.pop_back();
        if (!seen.insert(now).second) continue;
        all.push_back(now);
        if (is_choice(g[now])) open.insert(open.end(), {g[now].children[2], g[now].children[3]});
    }
    std::ranges::sort(all);
    return all;
}

// 2*(x < y) holds where x < y does.
NodeId without_factors(const Graph& g, NodeId condition) {
    while (g[condition].op == Op::multiply) {
        const NodeId factor = g[condition].children[0]; // where constants are
        if (!g.is_constant(factor) || g[factor].value == 0) break;
        condition = g[condition].children[1];
    }
    return condition;
}

bool is_0_or_1(const Graph& g, NodeId id) { return g.is_constant(id, 0) || g.is_constant(id, 1); }

// Both: the part's own solid within `where`.
NodeId cut(Graph& g, NodeId where, NodeId part) { return g.binary(Op::max, where, part); }

// The solid of a choice by a < b from those of its branches; of a branch that is 0 or 1 there is
// none.
NodeId solid_of_choice(Graph& g, const Node& node, NodeId then, NodeId otherwise) {
    const auto [a, b, c, d] = node.children;
    const NodeId inside = g.subtract(a, b), outside = g.subtract(b, a); // below 0 where a < b, not
    const auto is = [&](NodeId branch, double value) { return g.is_constant(branch, value); };
    if (is(c, 1)) return is(d, 0) ? inside : g.binary(Op::min, inside, otherwise);
    if (is(d, 1)) return is(c, 0) ? outside : g.binary(Op::min, outside, then);
    if (is(d, 0)) return cut(g, inside, then);
    if (is(c, 0)) return cut(g, outside, otherwise);
    return g.binary(Op::min, cut(g, inside, then), cut(g, outside, otherwise));
}

// Looks at the next condition as long as each one comes out as `goes_on`. The last is made first,
// so that each is gone through once.
NodeId joined(Graph& g, std::span<const NodeId> conditions, bool goes_on) {
    if (conditions.size() == 1) return conditions[0];
    const NodeId one = g.constant(1), zero = g.constant(0);
    NodeId rest = goes_on ? one : zero;
    for (auto next = conditions.rbegin(); next != conditions.rend(); ++next)
        rest = goes_on ? choose(g, *next, rest, zero) : choose(g, *next, one, rest);
    return rest;
}

} // namespace

bool is_choice(const Node& node) { return node.op == Op::select && Op(node.index) == Op::select; }

NodeId is_less(Graph& graph, NodeId a, NodeId b) {
    return choice(graph, a, b, graph.constant(1), graph.constant(0));
}

NodeId is_at_most(Graph& graph, NodeId a, NodeId b) {
    return choice(graph, b, a, graph.constant(0), graph.constant(1));
}

NodeId choose(Graph& graph, NodeId condition, NodeId a, NodeId b) {
    condition = without_factors(graph, condition);
    if (!is_choice(graph[condition]) || !is_condition(graph, condition)) {
        if (graph.is_constant(condition)) return graph[condition].value != 0 ? a : b;
        return choice(graph, graph.constant(0), graph.unary(Op::abs, condition), a, b);
    }
    std::unordered_map<NodeId, NodeId> made;
    for (const NodeId id : choices_below(graph, condition)) {
        const Node node = graph[id]; // a copy: the graph grows
        const auto& of = node.children;
        made[id] = is_choice(node)   ? choice(graph, of[0], of[1], made.at(of[2]), made.at(of[3]))
                   : node.value != 0 ? a
                                     : b;
    }
    return made.at(condition);
}

NodeId are_all(Graph& graph, std::span<const NodeId> conditions) {
    return joined(graph, conditions, true);
}

NodeId is_any(Graph& graph, std::span<const NodeId> conditions) {
    return joined(graph, conditions, false);
}

bool is_condition(const Graph& graph, NodeId id) {
    return std::ranges::all_of(choices_below(graph, id), [&](NodeId below) {
        return is_choice(graph[below]) || is_0_or_1(graph, below);
    });
}

NodeId solid_of(Graph& graph, NodeId condition) {
    std::unordered_map<NodeId, NodeId> made;
    for (const NodeId id : choices_below(graph, condition)) {
        const Node node = graph[id]; // a copy: the graph grows
        made[id] = is_choice(node) ? solid_of_choice(graph, node, made.at(node.children[2]),
                                                     made.at(node.children[3]))
                                   : id;
    }
    return made.at(condition);
}

} // namespace isomotion::formula
