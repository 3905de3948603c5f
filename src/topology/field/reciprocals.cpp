#include "topology/field/reciprocals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "formula/graph/sign.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Node;
using formula::NodeId;
using formula::Op;

struct Power {
    NodeId of{};
    int exponent = 1;
};

constexpr int highest = 24; // power; as_power() looks no deeper

Power as_power(const Graph& g, NodeId id, int depth = highest) {
    const Node& node = g[id];
    if (node.op != Op::multiply || depth == 0) return {id, 1};
    const Power a = as_power(g, node.children[0], depth - 1);
    const bool is_square = node.children[0] == node.children[1];
    const Power b = is_square ? a : as_power(g, node.children[1], depth - 1);
    if (a.of != b.of || a.exponent + b.exponent > highest) return {id, 1};
    return {a.of, a.exponent + b.exponent};
}

// The largest 1/s^n that is taken as a power. Divisions are cut off at 10^30, where a/s^n is cut as
// a whole and a (1/s)^n is not.
constexpr double highest_value = 1e24;

// The other summand of s, as r^2 of 1 + r^2, if s is a sum with a constant above 0: such a divisor
// hardly comes to 0. Empty for other divisors, whose even powers are bounded better at a pole.
std::optional<NodeId> above_constant(const Graph& g, const Power& s) {
    const Node& node = g[s.of];
    if (node.op != Op::add) return std::nullopt;
    for (const std::size_t k : {0, 1}) {
        const Node& least = g[node.children[k]];
        if (least.op != Op::constant || !(least.value > 0)) continue;
        if (std::pow(least.value, s.exponent) * highest_value >= 1) return node.children[1 - k];
    }
    return std::nullopt;
}

// Decoration: 0 over boxes where 1/s^n stays below that, else the entire line. Slopes have it, too.
NodeId unless_cut_off(Graph& g, NodeId reciprocal, const Power& s) {
    return g.select(g.unary(Op::abs, reciprocal),
                    g.constant(std::pow(highest_value, 1.0 / s.exponent)), g.constant(0),
                    g.constant(std::numeric_limits<double>::quiet_NaN()));
}

bool depends_on_inputs(const Graph& g, NodeId root) {
    return std::ranges::any_of(formula::nodes_below(g, std::array{root}),
                               [&](NodeId id) { return g[id].op == Op::input; });
}

} // namespace

NodeId with_reciprocals(Graph& graph, NodeId root) {
    const auto rewrite = [&](Graph& g, const Node&, NodeId rebuilt) {
        const Node node = g[rebuilt];
        if (node.op != Op::divide) return rebuilt;
        const Power divisor = as_power(g, node.children[1]);
        if (divisor.exponent < 2 || depends_on_inputs(g, node.children[0])) return rebuilt;
        const auto more = above_constant(g, divisor);
        if (!more) return rebuilt;
        const NodeId reciprocal = g.divide(g.constant(1), divisor.of);
        const NodeId product =
            g.multiply(node.children[0], g.integer_power(reciprocal, divisor.exponent));
        if (formula::is_never_negative(g, *more)) return product;
        return g.add(product, unless_cut_off(g, reciprocal, divisor));
    };
    return formula::substitute(graph, graph, std::array{root}, rewrite).front();
}

} // namespace isomotion::topology
