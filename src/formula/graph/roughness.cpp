#include "formula/graph/roughness.h"

#include <algorithm>
#include <vector>

#include "formula/graph/continuity.h"
#include "formula/graph/decoration.h"
#include "formula/graph/functions.h"
#include "formula/graph/sign.h"

namespace isomotion::formula {
namespace {

// Whether a node is 0 where it has its kink, so that a power of it may be smooth there.
bool is_0_at_kink(const Graph& g, const Node& node) {
    if (node.op == Op::abs) return true;
    return (node.op == Op::min || node.op == Op::max) &&
           (g.is_constant(node.children[0], 0) || g.is_constant(node.children[1], 0));
}

// Marks nodes whose every use is a power that is smooth at their kink.
std::vector<bool> smoothed(const Graph& g, NodeId root) {
    struct Power {
        NodeId of = 0;
        double exponent = 0; // 0 for what is no power of a kink
    };
    std::vector<Power> powers(std::size_t(root) + 1);
    std::vector<bool> is_smooth(std::size_t(root) + 1, true);
    const auto use = [&](const Power& power) {
        if (power.exponent == 0) return;
        const bool is_even = g[power.of].op == Op::abs && power.exponent == 2;
        if (power.exponent < smooth_power && !is_even) is_smooth[power.of] = false;
    };
    for (const NodeId id : nodes_below(g, std::array{root})) {
        const Node& node = g[id];
        const Power a = node.arity > 0 ? powers[node.children[0]] : Power{};
        const Power b = node.arity > 1 ? powers[node.children[1]] : Power{};
        if (node.op == Op::multiply && a.exponent > 0 && b.exponent > 0 && a.of == b.of) {
            powers[id] = {a.of, a.exponent + b.exponent};
        } else if (node.op == Op::power && a.exponent > 0 && g.is_constant(node.children[1]) &&
                   g[node.children[1]].value > 0) {
            powers[id] = {a.of, a.exponent * g[node.children[1]].value};
        } else {
            for (std::size_t k = 0; k < node.arity; ++k) use(powers[node.children[k]]);
            if (is_0_at_kink(g, node)) powers[id] = {id, 1};
        }
    }
    use(powers[root]);
    return is_smooth;
}

NodeId kink_of(Graph& g, NodeId id) {
    const Node node = g[id];
    const NodeId a = node.children[0], b = node.children[1], zero = g.constant(0);
    const auto unless_one_sign = [&](NodeId of) {
        return unless_one_value(g, g.unary(Op::sign, of));
    };
    if (node.op == Op::select) return unless_one_sign(g.subtract(a, b));
    if (node.op == Op::least || node.op == Op::pick) return unless_one_is_least(g, node);
    switch (breaks(node.op)) {
    case Breaks::kink_where_same:
        return unless_one_sign(g.subtract(a, b));
    case Breaks::base_at_0: { // unless the exponent is large
        const NodeId unless_large = unless_above(g, b, g.constant(smooth_power));
        return g.select(zero, a, zero, unless_large);
    }
    case Breaks::kink_at_0:
        return unless_one_sign(a);
    case Breaks::kink_at_1:
        return unless_one_sign(g.subtract(g.constant(1), g.unary(Op::abs, a)));
    case Breaks::begins_at_1:
        return unless_one_sign(g.subtract(a, g.constant(1)));
    default:
        return zero;
    }
}

NodeId pole_of(Graph& g, NodeId id, double least_part) {
    const Node node = g[id];
    const NodeId a = node.children[0], b = node.children[1], zero = g.constant(0);
    const auto unless_far = [&](NodeId size) {
        return unless_above(g, size, g.multiply(g.constant(least_part), size));
    };
    switch (breaks(node.op)) {
    // Beside a pole a quotient turns as fast as its denominator comes to a part of itself.
    case Breaks::pole_at_b_0:
        return unless_far(g.unary(Op::abs, b));
    case Breaks::base_at_0:
        return g.select(zero, a, zero, unless_above(g, b, zero));
    case Breaks::axis: // as fast as one over the distance
    case Breaks::cut:
        return unless_far(g.add(g.multiply(a, a), g.multiply(b, b)));
    case Breaks::turn: // as fast as 1 + u^2, the inverse of its slope
        if (g[a].op != Op::divide || g.is_constant(g[a].children[1])) return zero;
        return unless_far(g.add(g.constant(1), g.multiply(a, a)));
    case Breaks::pole_at_0:
        return unless_above(g, a, zero);
    case Breaks::poles:
        return unless_bounded(g, id);
    default:
        return zero;
    }
}

} // namespace

Roughness roughness(Graph& g, NodeId root, double least_part) {
    const std::vector<bool> is_smooth = smoothed(g, root), is_positive = positives(g, root);
    Roughness found;
    const auto add = [&](std::vector<NodeId>& to, NodeId decoration) {
        if (!g.is_constant(decoration, 0)) to.push_back(of_any_element(g, decoration));
    };
    for (const NodeId id : nodes_below(g, std::array{root})) {
        const Op op = g[id].op;
        const bool is_smoothed = is_0_at_kink(g, g[id]) && is_smooth[id];
        if (!is_smoothed) add(found.kinks, kink_of(g, id));
        if (may_jump(op) || op == Op::select || op == Op::pick)
            add(found.jumps, unless_continuous(g, id));
        const bool is_log_of_positive = op == Op::log && is_positive[g[id].children[0]];
        if (!is_log_of_positive) add(found.poles, pole_of(g, id, least_part));
    }
    add(found.poles, gaps(g, root));
    return found;
}

NodeId anywhere(Graph& g, const Roughness& roughness) {
    NodeId most = g.constant(0);
    for (const auto* places : {&roughness.kinks, &roughness.jumps, &roughness.poles}) {
        for (const NodeId decoration : *places) {
            if (g.is_constant(decoration)) return entire(g);
            most = g.binary(Op::max, most, decoration);
        }
    }
    return most;
}

} // namespace isomotion::formula
