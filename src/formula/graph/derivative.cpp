#include "formula/graph/derivative.h"

#include <cmath>
#include <limits>
#include <unordered_map>

#include "formula/graph/conditions.h"
#include "formula/graph/continuity.h"
#include "formula/graph/functions.h"
#include "formula/graph/lowering.h"
#include "formula/graph/sign.h"
#include "formula/graph/term.h"

namespace isomotion::formula {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(); // as an interval, the line

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
        case Op::constant: // what has no value has no slope
            return std::isnan(node.value) && slopes_ == Slopes::generalized ? id : zero();
        case Op::input:
        case Op::parameter:
        case Op::element:
            return leaf_(g_, id);
        case Op::random: {
            const bool rests = g_.is_constant(d(0), 0) && g_.is_constant(d(1), 0);
            return rests ? zero() : jumps(id);
        }
        case Op::noise: {
            NodeId slope = zero();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                NoiseOrder order = NoiseOrder::unpacked(node.index);
                if (g_.is_constant(d(int(axis)), 0)) continue;
                ++order.along[axis];
                const NodeId along = g_.noise({a, b, node.children[2]}, order);
                slope = g_.add(slope, g_.multiply(along, d(int(axis))));
            }
            return g_.is_constant(slope, 0) ? slope : g_.add(slope, jumps(id));
        }
        case Op::select: {
            const NodeId slope = g_.select(a, b, d(2), d(3));
            return is_choice(node) ? g_.add(slope, jumps(id)) : slope;
        }
        case Op::sum:
            return g_.sum(node.index, d(0));
        case Op::least:
            return g_.pick(node.index, a, d(0));
        case Op::pick:
            return g_.pick(node.index, a, d(1));
        case Op::which:
            return jumps(id);
        default:
            break;
        }
        if (node.arity == 1 && g_.is_constant(d(0), 0)) return zero();
        if (node.op == Op::negate) return g_.unary(Op::negate, d(0));
        if (node.arity == 2) return of_two(id, node, d(0), d(1));
        return g_.multiply(where_bounded(id, slope(id, node, a)), d(0));
    }

    // An operation on two arguments, whose slopes these are.
    NodeId of_two(NodeId id, const Node& node, NodeId slope_of_a, NodeId slope_of_b) {
        const Term a{&g_, node.children[0]}, b{&g_, node.children[1]}, f{&g_, id};
        const Term da{&g_, slope_of_a}, db{&g_, slope_of_b};
        switch (node.op) {
#define ROW(name, shader, sign_, extent, breaks, gaps, slope_)                                     \
    case Op::name:                                                                                 \
        return (slope_).node;
            ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
        default:
            return zero();
        }
    }

    // d f(a) / d a of the functions of one argument.
    NodeId slope(NodeId id, const Node& node, NodeId argument) {
        g_.constant(1); // before what may need it: the order of nodes is that of the shaders' text
        if (node.op == Op::chebyshev) return chebyshev_slope(node, argument);
        const Term a{&g_, argument}, f{&g_, id};
        switch (node.op) {
#define ROW(name, naming, shader, sign_, extent, at_0, breaks, gaps, domain, slope_)               \
    case Op::name:                                                                                 \
        return (slope_).node;
            ISOMOTION_FUNCTIONS(ROW)
#undef ROW
        default:
            return zero();
        }
    }

    NodeId chebyshev_slope(const Node& node, NodeId argument) {
        const NodeId next = g_.chebyshev(node.index, argument, node.second + 1);
        if (slopes_ != Slopes::generalized || node.index <= highest_whole_degree) return next;
        return g_.select(g_.unary(Op::abs, argument), g_.constant(chebyshev_reach(node.index)),
                         next, g_.constant(no_number));
    }

    // What slopes are written with in the table: the functions, and how they end.
#define ROW(name, ...)                                                                             \
    static Term name(Term a) { return a.of(Op::name); }
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW

    Term jumps(Term f) { return {&g_, jumps(f.node)}; }

    Term where_less(Op chosen, Term a, Term b, Term then, Term otherwise) {
        return {&g_, g_.select(a.node, b.node, then.node, otherwise.node, chosen)};
    }

    Term quotient_slope(Term a, Term b, Term f, Term da, Term db) {
        if (slopes_ == Slopes::pointwise_again && g_.is_constant(da.node, 0))
            return -((f / b) * db);
        // Between two points 1/b changes by the product of both reciprocals and the change of b:
        // one division for slopes of any order.
        if (slopes_ == Slopes::generalized && g_.is_constant(a.node, 1))
            return {&g_, where_bounded(f.node, (-((f * f) * db)).node)};
        // (a' - (a/b) b') / b shares the quotient with the value
        return {&g_, where_bounded(f.node, ((da - f * db) / b).node)};
    }

    NodeId jumps(NodeId id) {
        return slopes_ == Slopes::generalized ? unless_continuous(g_, id) : zero();
    }

    // The entire line where the operation `id` may have a pole, a value that is cut off (its slope
    // is 0 then, and another one on paper) or none: all of these have values without a bound. An
    // interval that has one is below the point at infinity, which begins at the largest number.
    NodeId where_bounded(NodeId id, NodeId slope) {
        if (slopes_ != Slopes::generalized || !may_be_unbounded(g_[id].op)) return slope;
        if (g_.is_constant(slope, 0)) return slope;
        return g_.select(g_.unary(Op::abs, id),
                         g_.constant(std::numeric_limits<double>::infinity()), slope,
                         g_.constant(no_number));
    }

    // sqrt is constant below 0, asin and acos beyond -1 and 1.
    Term where_rooted(Term a, Term slope) {
        if (slopes_ != Slopes::generalized && is_never_negative(g_, a.node)) return slope;
        return {&g_, g_.select(a.node, zero(), zero(), slope.node)};
    }
    Term within_unit(Term a, Term slope) {
        const Traits* row = traits(g_[a.node].op);
        const bool never_leaves_it = row && row->extent == Extent::unit;
        if (slopes_ != Slopes::generalized && never_leaves_it) return slope;
        return {&g_, g_.select(g_.constant(1), g_.unary(Op::abs, a.node), zero(), slope.node)};
    }

    // acosh is constant below 1.
    Term above_1(Term a, Term slope) {
        return {&g_, g_.select(g_.constant(1), a.node, slope.node, zero())};
    }

    // sqrt((1-a)(1+a)) keeps its digits where 1 - a^2 loses them.
    Term rest_of_unit(Term a) {
        const NodeId one = g_.constant(1);
        return {&g_,
                g_.unary(Op::sqrt, g_.multiply(g_.subtract(one, a.node), g_.add(one, a.node)))};
    }

    // b a^(b-1) a' + a^b log(a) b', the second half only where the exponent moves.
    Term power_slope(Term a, Term b, Term f, Term da, Term db) {
        return {&g_, where_bounded(f.node, unbounded_power_slope(a, b, f, da, db).node)};
    }

    Term unbounded_power_slope(Term a, Term b, Term f, Term da, Term db) {
        const Term lower = a.with(Op::power, b - b.number(1));
        const Term by_base = (b * lower) * da;
        if (g_.is_constant(db.node, 0)) return by_base;
        // A negative constant has powers at integers only: no slope, and no logarithm.
        if (g_.is_constant(a.node) && g_[a.node].value < 0)
            return a.number(slopes_ == Slopes::generalized ? no_number : 0);
        const Term all = by_base + (f * a.of(Op::log)) * db;
        if (slopes_ != Slopes::generalized) return all;
        return all + Term{&g_, unless_0_to_the_0(g_, a.node, b.node)};
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
