#include "formula/graph/power_sums.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formula/graph/operations.h"

namespace isomotion::formula {
namespace {

// Powers of less fade only near 0: x^15 below 0.003.
constexpr double least_exponent = 16;
constexpr double least_base = 1e-30;

// The base and the exponent of a product of equal factors, of which pairs may lack their abs();
// `left` bounds the search.
std::pair<NodeId, int> equal_factors(const Graph& graph, NodeId id, int& left) {
    const Node& node = graph[id];
    if (node.op != Op::multiply || --left < 0) return {id, 1};
    const auto [first, m] = equal_factors(graph, node.children[0], left);
    if (node.children[0] == node.children[1]) return {first, 2 * m};
    const auto [second, n] = equal_factors(graph, node.children[1], left);
    const auto is_size = [&](NodeId a, NodeId b) {
        return graph[a].op == Op::abs && graph[a].children[0] == b;
    };
    if (first == second || (m % 2 == 0 && is_size(second, first))) return {second, m + n};
    if (n % 2 == 0 && is_size(first, second)) return {first, m + n};
    return {id, 1};
}

// The base as it was before Graph::integer_power() kept the n-th power in range.
NodeId unlimited(const Graph& graph, NodeId base, int n) {
    const Node& high = graph[base];
    const std::optional<double> reach = Graph::reach(n);
    if (!reach || high.op != Op::max || !graph.is_constant(high.children[0], -*reach)) return base;
    const Node& low = graph[high.children[1]];
    return low.op == Op::min && graph.is_constant(low.children[0], *reach) ? low.children[1] : base;
}

// factor * over / under
struct Ratio {
    double factor = 1;
    std::optional<NodeId> over{}, under{};
};

Ratio ratio(const Graph& graph, NodeId id) {
    const Node& node = graph[id];
    const auto constant = [&](std::size_t k) { return graph.is_constant(node.children[k]); };
    const auto value = [&](std::size_t k) { return graph[node.children[k]].value; };
    if (node.op == Op::constant) return {node.value};
    if (node.op == Op::multiply && constant(0)) {
        Ratio rest = ratio(graph, node.children[1]);
        rest.factor *= value(0);
        return rest;
    }
    if (node.op == Op::divide) {
        Ratio over = ratio(graph, node.children[0]);
        if (constant(1)) {
            over.factor /= value(1);
            return over;
        }
        if (!over.under) {
            over.under = node.children[1];
            return over;
        }
    }
    return {1, id};
}

// p*q, if it does not change.
std::optional<double> constant_product(const Graph& graph, NodeId p, NodeId q) {
    const Ratio a = ratio(graph, p), b = ratio(graph, q);
    if (a.over != b.under || a.under != b.over) return std::nullopt;
    const double product = a.factor * b.factor, whole = std::round(product);
    return std::abs(product - whole) < 1e-12 * std::abs(product) ? whole : product; // 49 * (1/49.0)
}

} // namespace

PowerOfSum::PowerOfSum(Term sum, Term q)
    : q_(q) {
    add_terms(sum, 1);
}

void PowerOfSum::add_terms(Term a, double factor) {
    Graph& graph = *a.graph;
    const Node node = graph[a.node]; // a copy: the graph grows
    const Term first{&graph, node.children[0]}, second{&graph, node.children[1]};
    if (!is_sum_of_powers_) return;
    if (--left_ < 0) {
        is_sum_of_powers_ = false;
    } else if (node.op == Op::constant) {
        constants_.push_back(factor * node.value);
    } else if (node.op == Op::add) {
        add_terms(first, factor);
        add_terms(second, factor);
    } else if (node.op == Op::multiply && graph.is_constant(first.node)) {
        add_terms(second, factor * graph[first.node].value);
    } else if (node.op == Op::divide && graph.is_constant(second.node)) {
        add_terms(first, factor / graph[second.node].value);
    } else if (node.op == Op::power) {
        add_power(factor, first, second);
    } else {
        const auto [base, n] = equal_factors(graph, a.node, left_);
        add_power(factor, {&graph, unlimited(graph, base, n)}, a.number(n));
    }
}

void PowerOfSum::add_power(double factor, Term base, Term exponent) {
    is_sum_of_powers_ = factor > 0 && (!p_ || p_->node == exponent.node);
    p_ = exponent;
    terms_.push_back({factor, base});
}

bool PowerOfSum::has_largest() const {
    const auto is_above_0 = [](double number) { return number > 0; };
    if (!is_sum_of_powers_ || terms_.empty() || !std::ranges::all_of(constants_, is_above_0))
        return false;
    const Graph& graph = *q_.graph;
    const std::optional<double> degree = constant_product(graph, p_->node, q_.node);
    if (!degree) return false;
    if (!graph.is_constant(p_->node)) return *degree > 0;
    const double p = graph[p_->node].value;
    return p >= least_exponent && *degree > 0 && *degree <= 0.5 * p;
}

Term PowerOfSum::largest() const {
    Term most = q_.number(constants_.empty() ? least_base : 1);
    for (const Power& term : terms_) most = max(most, term.base.of(Op::abs));
    return min(most, most.number(Operations<float>::saturation()));
}

Term PowerOfSum::value(Term m) const {
    Graph& graph = *q_.graph;
    const Node exponent = graph[p_->node]; // a copy: the graph grows
    const double p = exponent.value;
    const bool is_whole = exponent.op == Op::constant && p == std::floor(p);
    const auto power = [&](Term base) {
        return is_whole ? Term{&graph, graph.integer_power(base.node, int(p))}
                        : base.with(Op::power, *p_);
    };
    Term rest = m.number(0);
    for (const Power& term : terms_) rest = rest + term.factor * power(term.base / m);
    for (const double constant : constants_) rest = rest + constant * power(1 / m);
    const double degree = *constant_product(graph, p_->node, q_.node);
    return m.with(Op::power, m.number(degree)) * rest.with(Op::power, q_);
}

} // namespace isomotion::formula
