#include "formula/graph/sign.h"

#include <cmath>

#include "formula/graph/functions.h"

namespace isomotion::formula {
namespace {

// Whether the form shows that values are from -1 to 1.
bool is_within_one(const Graph& g, NodeId id, int depth) {
    if (depth == 0) return false;
    const Node& node = g[id];
    const auto child = [&](std::size_t k) { return is_within_one(g, node.children[k], depth - 1); };
    switch (node.op) {
    case Op::constant:
        return std::abs(node.value) <= 1;
    case Op::sin:
    case Op::cos:
    case Op::tanh:
    case Op::sign:
        return true;
    case Op::negate:
    case Op::abs:
        return child(0);
    case Op::multiply:
    case Op::min:
    case Op::max:
        return child(0) && child(1);
    default:
        return false;
    }
}

// c + a or c - a, where a constant c is at least what |a| may be.
bool outweighs_a_wave(const Graph& g, const Node& node, int depth) {
    const auto is_beside = [&](std::size_t c, std::size_t a) {
        const Node& number = g[node.children[c]];
        return number.op == Op::constant && number.value >= 1 &&
               is_within_one(g, node.children[a], depth);
    };
    return is_beside(0, 1) || (node.op == Op::add && is_beside(1, 0));
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
        return node.children[0] == node.children[1] || (child(0) && child(1));
    case Op::add:
        return (child(0) && child(1)) || outweighs_a_wave(g, node, depth);
    case Op::subtract:
        return outweighs_a_wave(g, node, depth);
    case Op::divide:
    case Op::min:
        return child(0) && child(1);
    case Op::max:
        return child(0) || child(1);
    case Op::select:
        return child(2) && child(3);
    case Op::sum:
    case Op::least:
        return child(0);
    case Op::pick:
        return child(1);
    case Op::power: {
        const NodeId exponent = node.children[1];
        const bool is_even = g.is_constant(exponent) && std::fmod(g[exponent].value, 2) == 0;
        return is_even || child(0);
    }
    default: {
        const UnaryTraits* traits = unary_traits(node.op);
        if (!traits) return false;
        return traits->sign == Sign::not_negative ||
               (traits->sign == Sign::as_argument && child(0));
    }
    }
}

} // namespace isomotion::formula
