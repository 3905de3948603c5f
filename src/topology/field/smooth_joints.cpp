#include "topology/field/smooth_joints.h"

#include <array>
#include <unordered_map>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/functions.h"
#include "formula/graph/substitute.h"
#include "formula/graph/term.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

struct Blend {
    formula::Term a, b, k;
};

// k of max(-1, min((b - a)/k, 1)), where k may be kept above 10^-30.
std::optional<NodeId> width_between(const Graph& g, NodeId id, NodeId a, NodeId b) {
    const Node& high = g[id];
    if (high.op != Op::max || !g.is_constant(high.children[0], -1)) return std::nullopt;
    const Node& low = g[high.children[1]];
    if (low.op != Op::min || !g.is_constant(low.children[1], 1)) return std::nullopt;
    const Node& quotient = g[low.children[0]];
    if (quotient.op != Op::divide) return std::nullopt;
    const Node& apart = g[quotient.children[0]];
    if (apart.op != Op::subtract || apart.children[0] != b || apart.children[1] != a)
        return std::nullopt;
    const Node& width = g[quotient.children[1]];
    const bool is_kept = width.op == Op::max && g.is_constant(width.children[1], 1e-30);
    return is_kept ? width.children[0] : quotient.children[1];
}

// What smoothmin() of the formula's functions has made.
std::optional<Blend> as_blend(Graph& g, NodeId id) {
    const Node outer = g[id];
    if (outer.op != Op::min) return std::nullopt;
    const Node inner = g[outer.children[0]];
    if (inner.op != Op::min) return std::nullopt;
    const NodeId a = inner.children[1], b = outer.children[1];
    for (const NodeId below : formula::nodes_below(g, std::array{inner.children[0]})) {
        const auto k = width_between(g, below, a, b);
        if (!k) continue;
        const std::array<NodeId, 3> arguments{a, b, *k};
        if (formula::find_function("smoothmin")->call(g, arguments) == id)
            return Blend{{&g, a}, {&g, b}, {&g, *k}};
    }
    return std::nullopt;
}

// Whether an expression is above 0 everywhere, at all times of the clock.
bool is_above_0(const Graph& g, NodeId id, const Motion& motion) {
    formula::Evaluator<Interval> evaluator(formula::schedule(g, std::array{id}));
    std::array<Interval, clock_input + 1> inputs;
    inputs.fill(Interval::entire());
    inputs[clock_input] = motion.clock;
    Interval value;
    evaluator.point(formula::convert<Interval>(motion.bindings), inputs, {&value, 1});
    return value.lo > 1e-30; // below, smoothmin is another function
}

// Coefficients of the powers of |first - second|.
using Polynomial = std::vector<NodeId>;
constexpr std::size_t most_coefficients = 7;

class InHeight {
public:
    InHeight(Graph& graph, const Difference& height)
        : g_(graph)
        , height_(height) {}

    // None if `root` is no polynomial in it, or of too high a degree.
    std::optional<Polynomial> of(NodeId root) {
        for (const NodeId id : formula::nodes_below(g_, std::array{root})) {
            const auto powers = of(g_[id], id);
            if (!powers || powers->size() > most_coefficients) return std::nullopt;
            known_.emplace(id, *powers);
        }
        return known_.at(root);
    }

private:
    std::optional<Polynomial> of(Node node, NodeId id) {
        const auto compared = difference(g_, node);
        if (compared && is_the_same(*compared, height_)) {
            if (node.op == Op::abs) return Polynomial{g_.constant(0), g_.constant(1)};
            const NodeId half = g_.constant(0.5), sum = g_.add(compared->first, compared->second);
            return Polynomial{g_.multiply(half, sum), g_.constant(node.op == Op::min ? -0.5 : 0.5)};
        }
        bool depends = false;
        for (std::size_t k = 0; k < node.arity; ++k)
            depends = depends || known_.at(node.children[k]).size() > 1;
        if (!depends) return Polynomial{id};
        const Polynomial a = known_.at(node.children[0]);
        const Polynomial b = node.arity > 1 ? known_.at(node.children[1]) : Polynomial{};
        switch (node.op) {
        case Op::negate:
            return by(a, [&](NodeId one) { return g_.unary(Op::negate, one); });
        case Op::add:
        case Op::subtract:
            return sum(node.op, a, b);
        case Op::multiply:
            return product(a, b);
        case Op::divide:
            if (b.size() > 1) return std::nullopt;
            return by(a, [&](NodeId one) { return g_.divide(one, b[0]); });
        default:
            return std::nullopt;
        }
    }

    template<class Change> Polynomial by(Polynomial a, Change&& change) {
        for (NodeId& one : a) one = change(one);
        return a;
    }
    Polynomial sum(Op op, Polynomial a, Polynomial b) {
        const std::size_t size = std::max(a.size(), b.size());
        a.resize(size, g_.constant(0));
        b.resize(size, g_.constant(0));
        for (std::size_t k = 0; k < size; ++k) a[k] = g_.binary(op, a[k], b[k]);
        return a;
    }
    Polynomial product(const Polynomial& a, const Polynomial& b) {
        Polynomial all(a.size() + b.size() - 1, g_.constant(0));
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t j = 0; j < b.size(); ++j)
                all[i + j] = g_.add(all[i + j], g_.multiply(a[i], b[j]));
        }
        return all;
    }

    Graph& g_;
    Difference height_;
    std::unordered_map<NodeId, Polynomial> known_;
};

bool is_0(const Graph& g, NodeId id, const std::vector<Interval>& fixed) {
    Graph exact;
    exact.fold_exactly();
    const auto with_values = [&](Graph& to, const Node& node, NodeId rebuilt) {
        if (node.op != Op::parameter) return rebuilt;
        const Interval value = fixed.at(std::size_t(node.index));
        return is_point(value) ? to.constant(value.lo) : rebuilt;
    };
    return exact.is_constant(formula::substitute(exact, g, std::array{id}, with_values)[0], 0);
}

} // namespace

NodeId with_blends_in_pieces(Graph& graph, const Motion& motion, std::vector<Narrower>& narrower) {
    return formula::substitute(
        graph, graph, std::array{motion.field}, [&](Graph& to, const Node&, NodeId rebuilt) {
            const auto blend = to[rebuilt].arrays == 0 ? as_blend(to, rebuilt) : std::nullopt;
            if (!blend || !is_above_0(to, blend->k.node, motion)) return rebuilt;
            const formula::Term a = blend->a, b = blend->b, k = blend->k;
            const auto by = [&](formula::Term part) {
                return b + part * (a - b) - k * (part * (1.0 - part));
            };
            const formula::Term part = 0.5 + 0.5 * ((b - a) / k), apart = a - b;
            const formula::Term melted = 0.5 * (a + b) - (0.25 * k + apart * apart / (4.0 * k));
            narrower.push_back({by(part).node, melted.node});
            narrower.push_back({by(k.number(1)).node, a.node});
            return by(max(min(part, k.number(1)), k.number(0))).node;
        })[0];
}

std::optional<NodeId> without_even_height(Graph& graph, NodeId root, const Difference& height,
                                          const std::vector<Interval>& fixed) {
    const auto powers = InHeight(graph, height).of(root);
    if (!powers || powers->size() < 2) return std::nullopt;
    for (std::size_t k = 1; k < powers->size(); k += 2) {
        if (!is_0(graph, (*powers)[k], fixed)) return std::nullopt;
    }
    const NodeId apart = graph.subtract(height.first, height.second);
    NodeId sum = (*powers)[0], power = graph.constant(1);
    for (std::size_t k = 2; k < powers->size(); k += 2) {
        power = graph.multiply(power, graph.multiply(apart, apart));
        sum = graph.add(sum, graph.multiply((*powers)[k], power));
    }
    return sum;
}

} // namespace isomotion::topology
