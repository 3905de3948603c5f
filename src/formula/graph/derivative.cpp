#include "formula/graph/derivative.h"

#include <limits>
#include <unordered_map>

#include "formula/graph/term.h"

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
    NodeId slope(NodeId id, const Node& node, NodeId argument) {
        g_.constant(1); // before what may need it: the order of nodes is that of the shaders' text
        if (node.op == Op::chebyshev) return g_.chebyshev(node.index, argument, node.second + 1);
        const Term a{&g_, argument}, f{&g_, id};
        switch (node.op) {
#define ROW(name, shader, sign_, domain, slope_)                                                   \
    case Op::name:                                                                                 \
        return (slope_).node;
            ISOMOTION_FUNCTIONS(ROW)
#undef ROW
        default:
            return zero();
        }
    }

    // What slopes are written with in the table: the functions, and how they end.
#define ROW(name, ...)                                                                             \
    static Term name(Term a) { return a.of(Op::name); }
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW

    Term jumps(Term f) { return {&g_, jumps(f.node)}; }

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
    Term where_rooted(Term a, Term slope) {
        if (slopes_ != Slopes::generalized) return slope;
        return {&g_, g_.select(a.node, zero(), zero(), slope.node)};
    }
    Term within_unit(Term a, Term slope) {
        if (slopes_ != Slopes::generalized) return slope;
        return {&g_, g_.select(g_.constant(1), g_.unary(Op::abs, a.node), zero(), slope.node)};
    }

    // sqrt((1-a)(1+a)) keeps its digits where 1 - a^2 loses them.
    Term rest_of_unit(Term a) {
        const NodeId one = g_.constant(1);
        return {&g_,
                g_.unary(Op::sqrt, g_.multiply(g_.subtract(one, a.node), g_.add(one, a.node)))};
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
