#include "formula/graph/chebyshev_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "formula/graph/functions.h"
#include "formula/graph/operations.h"
#include "formula/graph/substitute.h"
#include "formula/interval/interval.h"

namespace isomotion::formula {
namespace {

struct Range {
    double low = -infinity, high = infinity;
};

// The range that the expression shows, looked at down to this depth.
Range range(const Graph& g, NodeId id, int depth = 8) {
    const Node& node = g[id];
    if (node.op == Op::constant && std::isfinite(node.value)) return {node.value, node.value};
    if (depth == 0) return {};
    const auto child = [&](std::size_t k) { return range(g, node.children[k], depth - 1); };
    switch (node.op) {
    case Op::abs: {
        const auto [low, high] = child(0);
        return {std::max({low, -high, 0.0}), std::max(-low, high)};
    }
    case Op::min: {
        const Range a = child(0), b = child(1);
        return {std::min(a.low, b.low), std::min(a.high, b.high)};
    }
    case Op::max: {
        const Range a = child(0), b = child(1);
        return {std::max(a.low, b.low), std::max(a.high, b.high)};
    }
    default: {
        const Traits* row = traits(node.op);
        if (!row) return {};
        const bool is_unit = row->extent == Extent::unit;
        return {row->is_never_negative() ? 0 : is_unit ? -1 : -infinity, is_unit ? 1 : infinity};
    }
    }
}

// acos takes what is beyond 1 for 1.
NodeId within_unit(Graph& g, NodeId a) {
    const auto [low, high] = range(g, a);
    if (high > 1) a = g.binary(Op::min, g.constant(1), a);
    return low < -1 ? g.binary(Op::max, g.constant(-1), a) : a;
}

// A polynomial of degree 2 at most: its coefficients by ascending powers, which are whole numbers
// too small to be rounded.
using Quadratic = std::array<double, 3>;

std::optional<Quadratic> if_exact(const Quadratic& q) {
    const auto is_exact = [](double c) { return std::abs(c) < 1e6 && c == std::floor(c); };
    return std::ranges::all_of(q, is_exact) ? std::optional(q) : std::nullopt;
}

std::optional<Quadratic> product(const Quadratic& a, const Quadratic& b) {
    const bool is_higher = a[1] * b[2] != 0 || a[2] * b[1] != 0 || a[2] * b[2] != 0;
    if (is_higher) return std::nullopt;
    return if_exact(
        {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0]});
}

// The expression as a polynomial in u.
std::optional<Quadratic> quadratic(const Graph& g, NodeId id, NodeId u, int depth = 8) {
    if (id == u) return Quadratic{0, 1, 0};
    const Node& node = g[id];
    if (node.op == Op::constant) return if_exact({node.value, 0, 0});
    const bool is_arithmetic = node.op == Op::negate || node.op == Op::add ||
                               node.op == Op::subtract || node.op == Op::multiply;
    if (!is_arithmetic || depth == 0) return std::nullopt;
    const auto a = quadratic(g, node.children[0], u, depth - 1);
    if (!a) return std::nullopt;
    if (node.op == Op::negate) return product(*a, {-1, 0, 0});
    const auto b = quadratic(g, node.children[1], u, depth - 1);
    if (!b) return std::nullopt;
    if (node.op == Op::multiply) return product(*a, *b);
    const double sign = node.op == Op::add ? 1 : -1;
    return if_exact({(*a)[0] + sign * (*b)[0], (*a)[1] + sign * (*b)[1], (*a)[2] + sign * (*b)[2]});
}

// The radicand of a root as a polynomial in u, where u >= 1. The root may be a product of two.
std::optional<Quadratic> radicand(const Graph& g, NodeId root, NodeId u) {
    const Node& node = g[root];
    if (node.op == Op::sqrt) return quadratic(g, node.children[0], u);
    if (node.op != Op::multiply) return std::nullopt;
    const Node &a = g[node.children[0]], &b = g[node.children[1]];
    if (a.op != Op::sqrt || b.op != Op::sqrt) return std::nullopt;
    const auto p = quadratic(g, a.children[0], u), q = quadratic(g, b.children[0], u);
    // Both are there for all u >= 1 only if both factors are u - 1 and u + 1.
    const Quadratic below{-1, 1, 0}, above{1, 1, 0};
    const bool are_ends = (p == below && q == above) || (p == above && q == below);
    return are_ends ? product(below, above) : std::nullopt;
}

// u, if the node is acosh(u) or log(u + sqrt(u^2 - 1)) and u is 1 at least. acosh takes what is
// below 1 for 1.
std::optional<NodeId> acosh_argument(Graph& g, NodeId id) {
    if (g[id].op == Op::acosh) {
        const NodeId u = g[id].children[0];
        return range(g, u).low >= 1 ? u : g.binary(Op::max, g.constant(1), u);
    }
    if (g[id].op != Op::log) return std::nullopt;
    const Node& all = g[g[id].children[0]];
    if (all.op != Op::add) return std::nullopt;
    for (const std::size_t k : {0u, 1u}) {
        const NodeId u = all.children[k], root = all.children[1 - k];
        if (range(g, u).low >= 1 && radicand(g, root, u) == Quadratic{-1, 0, 1}) return u;
    }
    return std::nullopt;
}

std::optional<NodeId> acos_argument(const Graph& g, NodeId id) {
    return g[id].op == Op::acos ? std::optional(g[id].children[0]) : std::nullopt;
}

struct Multiple {
    int times;
    NodeId node;
};

using NumberOf = std::function<std::optional<double>(int parameter)>;

std::optional<double> number(const Graph& g, NodeId id, const NumberOf& of_parameter) {
    const Node& node = g[id];
    if (node.op == Op::constant) return node.value;
    return node.op == Op::parameter ? of_parameter(node.index) : std::nullopt;
}

std::optional<Multiple> whole_multiple(const Graph& g, NodeId id, const NumberOf& of_parameter) {
    const Node& node = g[id];
    if (node.op != Op::multiply) return std::nullopt;
    for (const std::size_t k : {0u, 1u}) {
        const auto factor = number(g, node.children[k], of_parameter);
        if (!factor) continue;
        const double n = std::abs(*factor);
        if (n != std::floor(n) || n < 2 || n > limits::chebyshev_degree) return std::nullopt;
        return Multiple{int(n), node.children[1 - k]};
    }
    return std::nullopt;
}

// Something that is cut off at its end, or goes on without end.
NodeId cut_off(Graph& g) { return g.unary(Op::cosh, g.constant(100)); }

// Where saturation cuts off at the latest.
NodeId end_of_cut_off(Graph& g) {
    return g.constant(0.999 * double(Operations<float>::saturation()));
}

// cosh may be cut off where T_n is not: beyond the end it is either of both.
NodeId cut_off(Graph& g, NodeId t) {
    const NodeId end = end_of_cut_off(g);
    return g.select(t, end, t, cut_off(g));
}

// The same for T_n where T_n(-1), which may be negative, times what is cut off stands to the left.
NodeId cut_off_at_both_ends(Graph& g, NodeId t) {
    const NodeId end = end_of_cut_off(g);
    const NodeId below = g.unary(Op::negate, cut_off(g));
    return g.select(g.unary(Op::negate, t), end, cut_off(g, t), below);
}

std::optional<NodeId> inside_cut_off(Graph& g, NodeId id) {
    const Node node = g[id]; // a copy: the graph may grow
    const bool is_cut_off = node.op == Op::select && node.children[0] == node.children[2] &&
                            node.children[3] == cut_off(g);
    return is_cut_off ? std::optional(node.children[0]) : std::nullopt;
}

// The other operand of two different ones, of which one is that constant, in either order.
std::optional<NodeId> other_than(const Graph& g, const Node& node, double constant) {
    for (const std::size_t k : {0u, 1u})
        if (g.is_constant(node.children[k], constant)) return node.children[1 - k];
    return std::nullopt;
}

// Whether p is a where a is in [-1, 1], and else the end that is nearer.
bool is_within_unit_of(const Graph& g, NodeId p, NodeId a) {
    bool stops_below = range(g, a).low >= -1, stops_above = range(g, a).high <= 1;
    for (int depth = 0; p != a && depth < 4; ++depth) {
        const Node& node = g[p];
        const bool is_above = node.op == Op::min, is_below = node.op == Op::max;
        if (!is_above && !is_below) return false;
        const auto inner = other_than(g, node, is_above ? 1 : -1);
        if (!inner) return false;
        stops_above = stops_above || is_above;
        stops_below = stops_below || is_below;
        p = *inner;
    }
    return p == a && stops_below && stops_above;
}

// The argument of both, if `inside` is T_n where it counts inside and `outside` where it does
// outside.
std::optional<NodeId> joined(Graph& g, NodeId inside, NodeId outside) {
    const Node t = g[inside], far = g[outside]; // copies: the graph may grow
    const auto is_polynomial = [](const Node& node) {
        return node.op == Op::chebyshev && node.second == 0;
    };
    if (!is_polynomial(t) || !is_polynomial(far) || t.index != far.index) return std::nullopt;
    const Node& most = g[far.children[0]];
    const auto a = most.op == Op::max ? other_than(g, most, 1) : std::nullopt;
    if (!a) return std::nullopt;
    const bool is_even = t.index % 2 == 0, is_size = g[*a].op == Op::abs;
    if (is_within_unit_of(g, t.children[0], *a) && range(g, *a).low >= -1)
        return g.chebyshev(t.index, is_size && is_even ? g[*a].children[0] : *a);
    // T_n(-1) tells the sign of what is on the left.
    if (is_size && is_within_unit_of(g, t.children[0], g[*a].children[0]))
        return g.chebyshev(t.index, g[*a].children[0]);
    return std::nullopt;
}

// cosh as it is evaluated, or without end.
enum class Cosh { is_cut_off, is_whole };

// What stands for the node; itself, if it has no such form.
NodeId polynomial(Graph& g, NodeId id, Cosh cosh, const NumberOf& of_parameter) {
    const Node node = g[id]; // a copy: the graph grows below
    const NodeId a = node.children[0], b = node.children[1];
    const bool is_cut_off = cosh == Cosh::is_cut_off;
    switch (node.op) {
    case Op::cos:
        if (const auto angle = whole_multiple(g, a, of_parameter))
            if (const auto x = acos_argument(g, angle->node))
                return g.chebyshev(angle->times, within_unit(g, *x));
        return id;
    case Op::cosh:
        if (const auto angle = whole_multiple(g, a, of_parameter)) {
            if (const auto u = acosh_argument(g, angle->node)) {
                const NodeId t = g.chebyshev(angle->times, *u);
                return is_cut_off ? cut_off(g, t) : t;
            }
        }
        return id;
    case Op::multiply:
        for (const auto& [inside, outside] : {std::pair(a, b), std::pair(b, a)}) {
            const auto beyond = is_cut_off ? inside_cut_off(g, outside) : outside;
            if (!beyond) continue;
            if (const auto all = joined(g, inside, *beyond))
                return is_cut_off ? cut_off_at_both_ends(g, *all) : *all;
        }
        return id;
    default:
        return id;
    }
}

NodeId with_polynomials(Graph& graph, NodeId root, Cosh cosh, const NumberOf& of_parameter) {
    const std::vector<NodeId> below = nodes_below(graph, std::array{root});
    const auto has_form = [&](NodeId id) {
        const Node node = graph[id];
        return (node.op == Op::cos || node.op == Op::cosh) &&
               polynomial(graph, id, cosh, of_parameter) != id;
    };
    if (std::ranges::none_of(below, has_form)) return root;
    const Graph from = graph;
    const auto in_its_place = [&](Graph& to, const Node&, NodeId rebuilt) {
        return polynomial(to, rebuilt, cosh, of_parameter);
    };
    return substitute(graph, from, std::array{root}, in_its_place).front();
}

} // namespace

NodeId with_chebyshev(Graph& graph, NodeId root) {
    const std::vector<NodeId> below = nodes_below(graph, std::array{root});
    const auto goes_through_elements = [&](NodeId id) { return is_over_elements(graph[id].op); };
    if (std::ranges::any_of(below, goes_through_elements)) return root;
    const auto no_parameter = [](int) { return std::optional<double>(); };
    return with_polynomials(graph, root, Cosh::is_cut_off, no_parameter);
}

NodeId chebyshev_on_paper(Graph& graph, NodeId root, const NumberOf& of_parameter) {
    return with_polynomials(graph, root, Cosh::is_whole, of_parameter);
}

NodeId with_whole_chebyshev(Graph& graph, NodeId root, bool told) {
    const NodeId written = with_chebyshev(graph, root);
    if (written == root) return root;
    const Graph from = graph;
    const auto up_to_end = [&](Graph& to, NodeId t) {
        return told ? to.binary(Op::min, t, end_of_cut_off(to)) : t;
    };
    const auto whole = [&](Graph& to, const Node&, NodeId rebuilt) {
        if (const auto inside = inside_cut_off(to, rebuilt)) return up_to_end(to, *inside);
        const Node node = to[rebuilt]; // a copy: the graph may grow
        const bool ends_below = node.op == Op::select && to[node.children[0]].op == Op::negate &&
                                node.children[3] == to.unary(Op::negate, cut_off(to));
        if (!ends_below) return rebuilt;
        const NodeId t = to[node.children[0]].children[0], above = up_to_end(to, t);
        if (node.children[2] != above) return rebuilt;
        return told ? to.binary(Op::max, above, to.unary(Op::negate, end_of_cut_off(to))) : t;
    };
    return substitute(graph, from, std::array{written}, whole).front();
}

} // namespace isomotion::formula
