#include "formula/graph/sign.h"

#include <cmath>

#include "formula/graph/functions.h"

namespace isomotion::formula {

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
