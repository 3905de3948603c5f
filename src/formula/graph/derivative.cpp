#include "formula/graph/derivative.h"

#include <limits>
#include <unordered_map>

namespace isomotion::formula {
namespace {

class Differentiation {
public:
    Differentiation(Graph& graph, const LeafDerivative& leaf, Slopes slopes)
        : g_(graph)
        , leaf_(leaf)
        , slopes_(slopes) {}

    NodeId of(NodeId root) {
        // Children have smaller ids, so one pass in id order needs no recursion, however deep the
        // formula. Only nodes below root get a derivative.
        std::vector<bool> live(std::size_t(root) + 1, false);
        live[root] = true;
        for (NodeId id = root + 1; id-- > 0;) {
            if (!live[id]) continue;
            const Node& node = g_[id];
            for (int k = 0; k < node.arity; ++k) live[node.children[std::size_t(k)]] = true;
        }
        for (NodeId id = 0; id <= root; ++id) {
            if (live[id]) derivatives_[id] = rule(id);
        }
        return derivatives_.at(root);
    }

private:
    NodeId rule(NodeId id) {
        const Node node = g_[id]; // a copy: the graph grows below
        const NodeId a = node.children[0], b = node.children[1];
        const auto d = [&](int k) { return derivatives_.at(node.children[std::size_t(k)]); };
        switch (node.op) {
        case Op::constant:
            return zero();
        case Op::input:
        case Op::parameter:
        case Op::element:
            return leaf_(g_, id);
        case Op::random: {
            const bool rests = g_.is_constant(d(0), 0) && g_.is_constant(d(1), 0);
            return rests ? zero() : scatters(id);
        }
        case Op::select:
            return g_.select(a, b, d(2), d(3));
        case Op::sum:
            return g_.sum(node.index, d(0));
        default:
            break;
        }
        if (node.arity == 1 && g_.is_constant(d(0), 0)) return zero();
        switch (node.op) {
        case Op::negate:
            return g_.unary(Op::negate, d(0));
        case Op::add:
            return g_.add(d(0), d(1));
        case Op::subtract:
            return g_.subtract(d(0), d(1));
        case Op::multiply:
            return g_.add(g_.multiply(d(0), b), g_.multiply(a, d(1)));
        case Op::divide:
            if (slopes_ == Slopes::pointwise_again && g_.is_constant(d(0), 0)) {
                return g_.unary(Op::negate, g_.multiply(g_.divide(id, b), d(1)));
            }
            // (a' - (a/b) b') / b shares the quotient with the value
            return g_.divide(g_.subtract(d(0), g_.multiply(id, d(1))), b);
        case Op::min:
            return g_.select(a, b, d(0), d(1));
        case Op::max:
            return g_.select(a, b, d(1), d(0));
        case Op::power:
            return power(id, a, b, d(0), d(1));
        default:
            return g_.multiply(slope(id, node, a), d(0));
        }
    }

    // d f(a) / d a of the functions of one argument.
    NodeId slope(NodeId id, const Node& node, NodeId a) {
        const NodeId one = g_.constant(1);
        switch (node.op) {
        case Op::abs:
            return g_.unary(Op::sign, a);
        case Op::sign:
        case Op::floor:
            return jumps(id);
        case Op::sqrt:
            return where_rooted(a, g_.divide(g_.constant(0.5), id));
        case Op::exp:
            return id;
        case Op::log:
            return g_.divide(one, a);
        case Op::sin:
            return g_.unary(Op::cos, a);
        case Op::cos:
            return g_.unary(Op::negate, g_.unary(Op::sin, a));
        case Op::tan:
            return g_.add(one, g_.multiply(id, id));
        case Op::sinh:
            return g_.unary(Op::cosh, a);
        case Op::cosh:
            return g_.unary(Op::sinh, a);
        case Op::tanh:
            return g_.subtract(one, g_.multiply(id, id));
        case Op::asin:
            return within_unit(a, g_.divide(one, root_of_one_minus_square(a)));
        case Op::acos:
            return within_unit(a, g_.divide(g_.constant(-1), root_of_one_minus_square(a)));
        case Op::atan:
            return g_.divide(one, g_.add(one, g_.multiply(a, a)));
        case Op::chebyshev:
            return g_.chebyshev(node.index, a, node.second + 1);
        default:
            return zero();
        }
    }

    // 0 where the step function `id` is constant, from 0 to infinity where it may jump: an interval
    // that isn't a point is neither less than itself nor not.
    NodeId jumps(NodeId id) {
        if (slopes_ != Slopes::generalized) return zero();
        return g_.select(id, id, g_.constant(std::numeric_limits<double>::infinity()), zero());
    }

    // ... and unbounded on both sides where `id` may jump up or down.
    NodeId scatters(NodeId id) {
        if (slopes_ != Slopes::generalized) return zero();
        const NodeId down = g_.constant(-std::numeric_limits<double>::infinity());
        return g_.add(jumps(id), g_.select(id, id, down, zero()));
    }

    // sqrt is constant below 0, asin and acos beyond -1 and 1.
    NodeId where_rooted(NodeId a, NodeId slope) {
        return slopes_ != Slopes::generalized ? slope : g_.select(a, zero(), zero(), slope);
    }
    NodeId within_unit(NodeId a, NodeId slope) {
        if (slopes_ != Slopes::generalized) return slope;
        return g_.select(g_.constant(1), g_.unary(Op::abs, a), zero(), slope);
    }

    // b a^(b-1) a' + a^b log(a) b', the second half only where the exponent moves.
    NodeId power(NodeId id, NodeId a, NodeId b, NodeId da, NodeId db) {
        const NodeId lower = g_.binary(Op::power, a, g_.subtract(b, g_.constant(1)));
        const NodeId by_base = g_.multiply(g_.multiply(b, lower), da);
        if (g_.is_constant(db, 0)) return by_base;
        // A negative constant has powers at integers only: no slope, and no logarithm.
        if (g_.is_constant(a) && g_[a].value < 0) return zero();
        return g_.add(by_base, g_.multiply(g_.multiply(id, g_.unary(Op::log, a)), db));
    }

    // sqrt((1-a)(1+a)) keeps its digits where 1 - a^2 loses them.
    NodeId root_of_one_minus_square(NodeId a) {
        const NodeId one = g_.constant(1);
        return g_.unary(Op::sqrt, g_.multiply(g_.subtract(one, a), g_.add(one, a)));
    }

    NodeId zero() { return g_.constant(0); }

    Graph& g_;
    const LeafDerivative& leaf_;
    Slopes slopes_;
    std::unordered_map<NodeId, NodeId> derivatives_;
};

} // namespace

NodeId differentiate(Graph& graph, NodeId root, const LeafDerivative& leaf, Slopes slopes) {
    return Differentiation(graph, leaf, slopes).of(root);
}

NodeId differentiate_inputs(Graph& graph, NodeId root, const std::vector<NodeId>& directions,
                            Slopes slopes) {
    const auto moves = [&directions](Graph& g, NodeId leaf) {
        const Node& node = g[leaf];
        const bool input = node.op == Op::input && std::size_t(node.index) < directions.size();
        return input ? directions[std::size_t(node.index)] : g.constant(0);
    };
    return differentiate(graph, root, moves, slopes);
}

} // namespace isomotion::formula
