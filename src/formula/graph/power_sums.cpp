#include "formula/graph/power_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formula/graph/operations.h"
#include "formula/graph/sign.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

// Powers below the least exponent come to 0 only near 0: x^15 below 0.003. A power of more factors
// than the most is an Op::power, as Graph::binary() makes it.
constexpr int least_exponent = 16, most_factors = 256;
constexpr double highest_degree = 8, least_factor = 1e-30;
// Its square's inverse is a number.
constexpr double least_base = 1e-18;

// The base and the exponent of a product of equal factors, of which pairs may lack their abs();
// `left` bounds the search.
std::pair<NodeId, int> equal_factors(const Graph& graph, NodeId id, int& left) {
    const Node& node = graph[id];
    if (node.op != Op::multiply || --left < 0) return {id, 1};
    const auto [first, m] = equal_factors(graph, node.children[0], left);
    const auto [second, n] = node.children[0] == node.children[1]
                                 ? std::pair{first, m}
                                 : equal_factors(graph, node.children[1], left);
    const auto is_size = [&](NodeId a, NodeId b) {
        return graph[a].op == Op::abs && graph[a].children[0] == b;
    };
    if (m + n > most_factors) return {id, 1};
    if (first == second || (m % 2 == 0 && is_size(second, first))) return {second, m + n};
    if (n % 2 == 0 && is_size(first, second)) return {first, m + n};
    return {id, 1};
}

// factor * over / under
struct Ratio {
    double factor = 1;
    std::optional<NodeId> over{}, under{};
};

Ratio ratio(const Graph& graph, NodeId id) {
    Ratio found;
    for (int steps = 0; steps < 4; ++steps) {
        const Node& node = graph[id];
        const auto constant = [&](std::size_t k) { return graph.is_constant(node.children[k]); };
        const auto value = [&](std::size_t k) { return graph[node.children[k]].value; };
        if (node.op == Op::constant) {
            found.factor *= node.value;
            return found;
        }
        if (node.op == Op::multiply && constant(0)) {
            found.factor *= value(0);
            id = node.children[1];
        } else if (node.op == Op::divide && constant(1)) {
            found.factor /= value(1);
            id = node.children[0];
        } else if (node.op == Op::divide && !found.under) {
            found.under = node.children[1];
            id = node.children[0];
        } else {
            break;
        }
    }
    found.over = id;
    return found;
}

// p*q, if it does not change.
std::optional<double> constant_product(const Graph& graph, NodeId p, NodeId q) {
    const Ratio a = ratio(graph, p), b = ratio(graph, q);
    if (a.over != b.under || a.under != b.over) return std::nullopt;
    const double product = a.factor * b.factor, whole = std::round(product);
    return std::abs(product - whole) < 1e-12 * std::abs(product) ? whole : product; // 49 * (1/49.0)
}

// The base of a whole power that is cut off, without that.
std::optional<NodeId> without_cut_off(const Graph& graph, NodeId base, double p) {
    const bool is_product = p == std::floor(p) && p <= most_factors;
    const std::optional<double> end = is_product ? Graph::reach(int(p)) : std::nullopt;
    const Node& high = graph[base];
    if (!end || high.op != Op::max || !graph.is_constant(high.children[0], -*end))
        return std::nullopt;
    const Node& low = graph[high.children[1]];
    if (low.op != Op::min || !graph.is_constant(low.children[0], *end)) return std::nullopt;
    return low.children[1];
}

} // namespace

PowerOfSum::PowerOfSum(Term sum, Term q)
    : q_(q)
    , p_(q) {
    add_terms(sum, {sum.number(1), 1});
}

void PowerOfSum::add_terms(Term a, const Factor& factor) {
    Graph& graph = *a.graph;
    const Node node = graph[a.node]; // a copy: the graph grows
    const Term first{&graph, node.children[0]}, second{&graph, node.children[1]};
    if (!is_sum_of_powers_) return;
    if (--left_ < 0) {
        is_sum_of_powers_ = false;
    } else if (node.op == Op::constant) {
        constants_.push_back({factor.exact * a, factor.number * node.value});
    } else if (node.op == Op::add) {
        add_terms(first, factor);
        add_terms(second, factor);
    } else if (node.op == Op::multiply && graph.is_constant(first.node)) {
        add_terms(second, {factor.exact * first, factor.number * graph[first.node].value});
    } else if (node.op == Op::divide && graph.is_constant(second.node)) {
        add_terms(first, {factor.exact / second, factor.number / graph[second.node].value});
    } else if (node.op == Op::power) {
        add_power(factor, first, second);
    } else {
        const auto [base, n] = equal_factors(graph, a.node, left_);
        add_power(factor, {&graph, base}, a.number(n));
    }
}

void PowerOfSum::add_power(const Factor& factor, Term base, Term exponent) {
    const Node& p = (*base.graph)[exponent.node];
    // An exponent that changes may become odd.
    const bool is_never_odd = p.op == Op::constant && std::fmod(p.value, 2) != 1;
    const bool is_counted =
        factor.number > least_factor && (is_never_odd || is_never_negative(*base.graph, base.node));
    is_sum_of_powers_ = is_counted && (powers_.empty() || p_.node == exponent.node);
    p_ = exponent;
    powers_.push_back({factor, base});
}

bool PowerOfSum::has_largest() const {
    const auto is_above_0 = [](const Factor& factor) { return factor.number > 0; };
    if (!is_sum_of_powers_ || powers_.empty() || !std::ranges::all_of(constants_, is_above_0))
        return false;
    const Graph& graph = *q_.graph;
    const bool is_constant = graph.is_constant(p_.node);
    const double p = graph[p_.node].value;
    if (is_constant && !(p >= least_exponent)) return false;
    const std::optional<double> degree = constant_product(graph, p_.node, q_.node);
    if (!degree || !(*degree > 0 && *degree <= highest_degree)) return false;
    return !is_constant || *degree <= 0.5 * p;
}

std::vector<PowerOfSum::Power> PowerOfSum::terms(Purpose purpose) const {
    std::vector<Power> all = powers_;
    const Node& p = (*q_.graph)[p_.node];
    // A small constant is not small beside a base of 1.
    const bool has_root = purpose == Purpose::numbers && p.op == Op::constant;
    for (const Factor& constant : constants_) {
        if (has_root)
            all.push_back({{q_.number(1), 1}, q_.number(std::pow(constant.number, 1 / p.value))});
        else
            all.push_back({constant, q_.number(1)});
    }
    return all;
}

Term PowerOfSum::largest(Purpose purpose) const {
    Graph& graph = *q_.graph;
    std::optional<Term> most, least;
    for (const Power& term : terms(purpose)) {
        const Term size = term.base.of(Op::abs);
        most = most ? max(*most, size) : size;
        least = least ? min(*least, size) : size;
    }
    const bool is_constant = graph.is_constant(p_.node);
    const Term first =
        is_constant
            ? *most
            : Term{&graph, graph.select(p_.node, graph.constant(0), least->node, most->node)};
    if (purpose == Purpose::bounds) return first;
    const Term above_0 = max(q_.number(least_base), first);
    if (purpose == Purpose::slopes) return above_0;
    const double degree = *constant_product(graph, p_.node, q_.node);
    const double end = std::pow(double(Operations<float>::saturation()), 1 / std::max(1.0, degree));
    return min(q_.number(end), above_0);
}

Term PowerOfSum::value(Term m, Purpose purpose) const {
    const bool is_bound = purpose == Purpose::bounds;
    std::optional<Term> rest;
    double least = std::numeric_limits<double>::infinity();
    for (const Power& term : terms(purpose)) {
        const Term part = is_bound ? max(m.number(0), term.base.of(Op::abs) / m) : term.base / m;
        const Term power = part.with(Op::power, p_);
        const Term added = term.factor.exact * (is_bound ? min(m.number(1), power) : power);
        rest = rest ? *rest + added : added;
        const double number = term.factor.number;
        least = std::min(least, number > least_factor ? 0.999999 * number : 0);
    }
    if (is_bound) rest = max(m.number(least), *rest);
    const double degree = *constant_product(*q_.graph, p_.node, q_.node);
    // Over boxes p*q is rounded outwards.
    const Term of_m = purpose == Purpose::numbers ? m.number(degree) : p_ * q_;
    return m.with(Op::power, of_m) * rest->with(Op::power, q_);
}

std::optional<Term> PowerOfSum::without_cut_offs() const {
    Graph& graph = *q_.graph;
    const double p = graph[p_.node].value;
    const auto has_end = [&](const Power& term) {
        return without_cut_off(graph, term.base.node, p).has_value();
    };
    if (!graph.is_constant(p_.node) || std::ranges::none_of(powers_, has_end)) return std::nullopt;
    Term sum = q_.number(0);
    for (const Power& term : powers_) {
        const NodeId base = without_cut_off(graph, term.base.node, p).value_or(term.base.node);
        sum = sum + term.factor.exact * Term{&graph, graph.repeated_product(base, int(p))};
    }
    for (const Factor& constant : constants_) sum = sum + constant.exact;
    return sum.with(Op::power, q_);
}

NodeId norms_without_cut_offs(Graph& graph, NodeId root) {
    return substitute_outside_sums(graph, root, [](Graph& to, const Node& node, NodeId rebuilt) {
        const Node now = to[rebuilt]; // a copy: the graph grows
        if (now.op != node.op || now.op != Op::power) return rebuilt;
        const PowerOfSum sum({&to, now.children[0]}, {&to, now.children[1]});
        const auto whole = sum.has_largest() ? sum.without_cut_offs() : std::nullopt;
        return whole ? whole->node : rebuilt;
    });
}

} // namespace isomotion::formula
