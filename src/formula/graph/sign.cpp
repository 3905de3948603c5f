#include "formula/graph/sign.h"

#include <algorithm>
#include <cmath>

#include "formula/graph/functions.h"
#include "formula/interval/noise_enclosure.h"

namespace isomotion::formula {
namespace {

// A number that the form shows no |value| to exceed; infinite if it shows none.
double most_magnitude(const Graph& g, NodeId id, int depth) {
    if (depth == 0) return HUGE_VAL;
    const Node& node = g[id];
    const auto child = [&](std::size_t k) {
        return most_magnitude(g, node.children[k], depth - 1);
    };
    switch (node.op) {
    case Op::constant:
        return std::isnan(node.value) ? HUGE_VAL : std::abs(node.value);
    case Op::negate:
    case Op::abs:
        return child(0);
    case Op::multiply: {
        const double a = child(0), b = child(1), product = a * b;
        // A rounded product might be too small.
        return std::isfinite(product) && std::fma(a, b, -product) == 0 ? product : HUGE_VAL;
    }
    case Op::min:
    case Op::max:
        return std::max(child(0), child(1));
    case Op::noise:
        return noise_bound(NoiseOrder::unpacked(node.index));
    default: {
        const Traits* row = traits(node.op);
        return row && row->extent == Extent::unit ? 1 : HUGE_VAL;
    }
    }
}

// max(b, q) - b, b - min(b, q), |b| - b.
bool is_excess(const Graph& g, const Node& difference) {
    const NodeId a = difference.children[0], b = difference.children[1];
    const auto is_of = [&](NodeId choice, Op op, NodeId part) {
        const Node& node = g[choice];
        return node.op == op && (node.children[0] == part || node.children[1] == part);
    };
    return is_of(a, Op::max, b) || is_of(b, Op::min, a) ||
           (g[a].op == Op::abs && g[a].children[0] == b);
}

// |x| + x
bool adds_its_size(const Graph& g, const Node& sum) {
    const auto is_size = [&](std::size_t k) {
        const Node& node = g[sum.children[k]];
        return node.op == Op::abs && node.children[0] == sum.children[1 - k];
    };
    return is_size(0) || is_size(1);
}

// c + a or c - a, where c is a constant: c less the most that |a| may be.
double least_beside_a_wave(const Graph& g, const Node& node, int depth) {
    const auto beside = [&](std::size_t c, std::size_t a) {
        const Node& number = g[node.children[c]];
        return number.op == Op::constant ? number.value - most_magnitude(g, node.children[a], depth)
                                         : -HUGE_VAL;
    };
    if (node.op == Op::add) return std::max(beside(0, 1), beside(1, 0));
    return node.op == Op::subtract ? beside(0, 1) : -HUGE_VAL;
}

} // namespace

bool is_never_negative(const Graph& g, NodeId id, int depth) {
    if (depth == 0) return false;
    const Node& node = g[id];
    const auto child = [&](std::size_t k) {
        return is_never_negative(g, node.children[k], depth - 1);
    };
    switch (node.op) {
    case Op::constant:
        return node.value >= 0;
    case Op::multiply:
        if (node.children[0] == node.children[1]) return true;
        break;
    case Op::add:
        if (adds_its_size(g, node) || least_beside_a_wave(g, node, depth) >= 0) return true;
        break;
    case Op::subtract:
        return is_excess(g, node) || least_beside_a_wave(g, node, depth) >= 0;
    case Op::select:
        return child(2) && child(3);
    case Op::sum:
    case Op::least:
        return child(0);
    case Op::pick:
        return child(1);
    case Op::power: {
        const NodeId exponent = node.children[1];
        if (g.is_constant(exponent) && std::fmod(g[exponent].value, 2) == 0) return true;
        break;
    }
    default:
        break;
    }
    const Traits* row = traits(node.op);
    return row && row->is_never_negative(child);
}

bool may_round_below_0(const Graph& g, NodeId id) { return least_beside_a_wave(g, g[id], 12) == 0; }

std::vector<bool> positives(const Graph& g, NodeId root) {
    std::vector<bool> found(std::size_t(root) + 1, false);
    const auto is_tanh = [&](NodeId id) { return g[id].op == Op::tanh; };
    const auto is_1_or_more = [&](NodeId id) {
        return g.is_constant(id) && g[id].value >= 1 && std::isfinite(g[id].value);
    };
    for (NodeId id = 0; id <= root; ++id) {
        const Node& node = g[id];
        const auto [a, b, c, d] = node.children;
        if (node.may_have_gaps) continue;
        switch (node.op) {
        case Op::constant:
            found[id] = node.value > 0 && std::isfinite(node.value);
            break;
        case Op::multiply:
        case Op::divide:
            found[id] = found[a] && found[b];
            break;
        case Op::add:
            found[id] = (found[a] && found[b]) || (is_1_or_more(a) && is_tanh(b)) ||
                        (is_1_or_more(b) && is_tanh(a));
            break;
        case Op::subtract:
            found[id] = is_1_or_more(a) && is_tanh(b);
            break;
        default: {
            const Traits* row = traits(node.op);
            found[id] = row && row->sign == Sign::positive;
        }
        }
    }
    return found;
}

} // namespace isomotion::formula
