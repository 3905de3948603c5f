#include "formula/graph/vanishing.h"

#include <array>

#include "formula/graph/functions.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {

std::vector<NodeId> vanishing(Graph& g, NodeId root) {
    const NodeId zero = g.constant(0), one = g.constant(1);
    const auto unless_above_0 = [&](NodeId a) { return g.select(zero, a, zero, one); };
    const auto unless_below_0 = [&](NodeId a) { return g.select(a, zero, zero, one); };
    std::vector<NodeId> is_0(std::size_t(root) + 1, zero);
    for (const NodeId id : nodes_below(g, std::array{root})) {
        const Node node = g[id]; // a copy: the graph grows
        const NodeId a = node.children[0], b = node.children[1];
        // A condition of other operands is made only where it counts.
        const auto where = [&](NodeId vanishes, auto&& condition) {
            return vanishes == zero ? zero : g.multiply(vanishes, condition());
        };
        switch (node.op) {
        case Op::constant:
            is_0[id] = node.value == 0 ? one : zero;
            break;
        case Op::parameter:
            is_0[id] = g.select(zero, g.unary(Op::abs, id), zero, one);
            break;
        case Op::negate:
            is_0[id] = is_0[a];
            break;
        case Op::floor:
            is_0[id] = g.add(is_0[a], g.select(a, zero, zero, g.select(a, one, one, zero)));
            break;
        case Op::add:
        case Op::subtract:
            is_0[id] = where(is_0[a], [&] { return is_0[b]; });
            break;
        case Op::multiply:
            is_0[id] = g.add(is_0[a], is_0[b]);
            break;
        case Op::divide:
            is_0[id] =
                where(is_0[a], [&] { return g.select(zero, g.unary(Op::abs, b), one, zero); });
            break;
        case Op::power:
        case Op::atan2:
        case Op::angle:
            is_0[id] = where(is_0[a], [&] { return g.select(zero, b, one, zero); });
            break;
        case Op::max:
            is_0[id] = g.add(where(is_0[a], [&] { return unless_above_0(b); }),
                             where(is_0[b], [&] { return unless_above_0(a); }));
            break;
        case Op::min:
            is_0[id] = g.add(where(is_0[a], [&] { return unless_below_0(b); }),
                             where(is_0[b], [&] { return unless_below_0(a); }));
            break;
        case Op::select: {
            const NodeId then = is_0[node.children[2]], otherwise = is_0[node.children[3]];
            is_0[id] = then == otherwise ? then : g.select(a, b, then, otherwise);
            break;
        }
        case Op::sum:
            if (is_0[a] != zero) {
                // Elements whose term may not be 0, counted.
                const NodeId others = g.sum(node.index, g.select(zero, is_0[a], zero, one));
                is_0[id] = g.select(others, g.constant(0.5), one, zero);
            }
            break;
        default: {
            const Traits* row = unary_traits(node.op);
            if (row && row->at_0 == At0::zero) is_0[id] = is_0[a];
        }
        }
    }
    return is_0;
}

} // namespace isomotion::formula
