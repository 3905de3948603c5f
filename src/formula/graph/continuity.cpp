#include "formula/graph/continuity.h"

#include <array>
#include <cmath>
#include <vector>

#include "formula/graph/decoration.h"
#include "formula/graph/functions.h"
#include "formula/graph/sign.h"
#include "formula/graph/vanishing.h"

namespace isomotion::formula {
namespace {

NodeId unless_without_kink(Graph& g, NodeId id) {
    const Node node = g[id];
    if (node.op == Op::least || node.op == Op::pick) return unless_one_is_least(g, node);
    if (node.op != Op::min && node.op != Op::max && node.op != Op::select) return g.constant(0);
    // What is chosen depends on how the comparison of the first two comes out.
    return unless_one_value(g, g.unary(Op::sign, g.subtract(node.children[0], node.children[1])));
}

bool is_whole(double x) { return x == std::floor(x); }

NodeId unless_gap(Graph& g, NodeId id, const std::vector<bool>& is_resting) {
    const Node node = g[id];
    const NodeId a = node.children[0], b = node.children[1], zero = g.constant(0);
    switch (node.op) {
    case Op::power: {
        if (g.is_constant(b) && is_whole(g[b].value)) return zero;
        const NodeId unless_whole = g.select(g.unary(Op::floor, b), b, entire(g), zero);
        return is_never_negative(g, a) ? zero : g.select(a, zero, unless_whole, zero);
    }
    case Op::log:
        return is_never_negative(g, a) ? zero : g.select(a, zero, entire(g), zero);
    case Op::divide: { // 0/0
        const NodeId unless_by_0 = g.select(zero, g.unary(Op::abs, b), zero, entire(g));
        // A divisor at rest is looked at once; the numerator would be looked at everywhere.
        if (is_resting[b] || g.is_constant(unless_by_0)) return unless_by_0;
        return g.select(zero, g.unary(Op::abs, a), zero, unless_by_0);
    }
    default:
        return zero;
    }
}

// Above 0 over boxes where the operation has no value anywhere though its arguments have; else 0 or
// more. `is_0`: vanishing().
NodeId is_nowhere(Graph& g, NodeId id, const std::vector<NodeId>& is_0) {
    const Node node = g[id];
    const NodeId a = node.children[0], b = node.children[1], zero = g.constant(0),
                 one = g.constant(1);
    switch (node.op) {
    case Op::constant:
        return std::isnan(node.value) ? one : zero;
    case Op::log:
        return g.select(a, zero, one, zero);
    case Op::power: {
        if (g.is_constant(b) && is_whole(g[b].value)) return zero;
        const NodeId is_not_whole = g.select(g.unary(Op::floor, b), b, one, zero);
        return g.select(a, zero, is_not_whole, zero);
    }
    case Op::divide: { // 0/0
        const NodeId unless_a = g.select(zero, g.unary(Op::abs, a), zero, one);
        const NodeId by_bounds = g.select(zero, g.unary(Op::abs, b), zero, unless_a);
        return g.add(by_bounds, g.multiply(is_0[a], is_0[b]));
    }
    default:
        return zero;
    }
}

NodeId unless_at_axis(Graph& g, NodeId a, NodeId b) {
    const NodeId zero = g.constant(0);
    return g.select(zero, g.unary(Op::abs, a), zero, unless_above(g, g.unary(Op::abs, b), zero));
}

NodeId unless_at_cut(Graph& g, NodeId a, NodeId b) {
    const NodeId zero = g.constant(0);
    return g.select(zero, g.unary(Op::abs, a), zero, unless_above(g, b, zero));
}

NodeId unless_between_cells(Graph& g, const Node& noise) {
    const NoiseOrder order = NoiseOrder::unpacked(noise.index);
    NodeId all = g.constant(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!jumps_between_cells(order.along[axis])) continue;
        const NodeId cell = g.unary(Op::floor, noise.children[axis]);
        all = g.add(all, unless_one_value(g, cell));
    }
    return all;
}

} // namespace

bool may_be_unbounded(Op op) {
    const Traits* row = traits(op);
    return row && row->extent == Extent::unbounded;
}

NodeId unless_0_to_the_0(Graph& g, NodeId base, NodeId exponent) {
    if (g.is_constant(exponent)) return g.constant(0);
    const NodeId zero = g.constant(0);
    return g.select(zero, base, zero, g.select(zero, exponent, zero, entire(g)));
}

NodeId unless_continuous(Graph& g, NodeId id) {
    const Node node = g[id];
    if (node.op == Op::power)
        return g.add(unless_bounded(g, id),
                     unless_0_to_the_0(g, node.children[0], node.children[1]));
    if (node.op == Op::noise) return unless_between_cells(g, node);
    const auto [a, b, c, d] = node.children;
    if (breaks(node.op) == Breaks::cut) return unless_at_cut(g, a, b);
    if (breaks(node.op) == Breaks::axis) return unless_at_axis(g, a, b);
    if (has_steps(node.op)) return unless_one_value(g, id);
    if (node.op == Op::select && node.children[2] != node.children[3])
        return unless_without_kink(g, id);
    if (node.op == Op::pick || node.op == Op::which) return unless_one_is_least(g, node);
    return may_be_unbounded(node.op) ? unless_bounded(g, id) : g.constant(0);
}

NodeId jumps(Graph& g, NodeId root) {
    // Enclosures of a sum of exponentials hold 0 where floats come to it, and its logarithm does
    // not jump there.
    const std::vector<bool> is_positive = positives(g, root);
    return all_below(g, root, [&](Graph& to, NodeId id) {
        const bool is_of_positive = to[id].op == Op::log && is_positive[to[id].children[0]];
        return is_of_positive ? to.constant(0) : unless_continuous(to, id);
    });
}

NodeId gaps(Graph& g, NodeId root) {
    std::vector<bool> is_resting(std::size_t(root) + 1, true); // without inputs and elements
    for (const NodeId id : nodes_below(g, std::array{root})) {
        const Node& node = g[id];
        is_resting[id] = node.op != Op::input && node.arrays == 0;
        for (std::size_t k = 0; k < node.arity; ++k)
            is_resting[id] = is_resting[id] && is_resting[node.children[k]];
    }
    return all_below(g, root, [&](Graph& to, NodeId id) { return unless_gap(to, id, is_resting); });
}

NodeId with_gaps(Graph& g, NodeId root) { return g.add(root, gaps(g, root)); }

NodeId without_value(Graph& g, NodeId root) {
    const NodeId zero = g.constant(0);
    std::vector<NodeId> none(std::size_t(root) + 1, zero);
    const std::vector<NodeId> is_0 = vanishing(g, root);
    for (const NodeId id : nodes_below(g, std::array{root})) {
        const Node node = g[id];
        const NodeId a = node.children[0], b = node.children[1];
        switch (node.op) {
        case Op::constant:
            none[id] = is_nowhere(g, id, is_0);
            break;
        case Op::log:
            none[id] = g.add(none[a], is_nowhere(g, id, is_0));
            break;
        case Op::power: {
            const bool is_product = g.is_constant(b) && is_whole(g[b].value);
            none[id] = is_product ? none[a] : g.add(none[a], is_nowhere(g, id, is_0));
            break;
        }
        case Op::divide:
            none[id] = g.add(is_nowhere(g, id, is_0), g.add(none[a], none[b]));
            break;
        case Op::sum:
            none[id] = none[a] == zero ? zero : g.sum(node.index, none[a]);
            break;
        case Op::select: { // by the branch that is taken
            const NodeId then = none[node.children[2]], otherwise = none[node.children[3]];
            none[id] = then == otherwise ? then : g.select(a, b, then, otherwise);
            break;
        }
        default: { // others may have values where their arguments have none
            const Traits* row = traits(node.op);
            const bool keeps = node.op == Op::negate || (row && row->gaps == Gaps::kept);
            if (keeps) none[id] = node.arity == 2 ? g.add(none[a], none[b]) : none[a];
        }
        }
    }
    return none[root];
}

NodeId within_gaps(Graph& g, NodeId root) {
    const std::vector<NodeId> is_0 = vanishing(g, root);
    return all_below(g, root, [&](Graph& to, NodeId id) { return is_nowhere(to, id, is_0); });
}

NodeId divided_by_0(Graph& g, NodeId root) {
    const std::vector<NodeId> is_0 = vanishing(g, root);
    return all_below(g, root, [&](Graph& to, NodeId id) {
        const Node node = to[id];
        return node.op == Op::divide ? is_0[node.children[1]] : to.constant(0);
    });
}

NodeId kinks(Graph& g, NodeId root) { return all_below(g, root, unless_without_kink); }

} // namespace isomotion::formula
