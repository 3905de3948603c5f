#include "topology/field/separable.h"

#include <algorithm>
#include <bit>

#include "formula/graph/substitute.h"
#include "topology/field/jet.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

// What a function and its slope are over an interval.
struct Slope {
    Interval value, slope;
};

// Finds the roots of a function of one unknown by bisection and Newton's method over intervals.
template<class Function> class Roots {
public:
    Roots(Function& function, Interval span)
        : function_(function)
        , span_(span) {}

    std::optional<std::vector<Root>> find() && {
        std::vector<Interval> open{span_};
        while (!open.empty()) {
            const Interval x = open.back();
            open.pop_back();
            if (!settle(x)) {
                // Symmetric functions have roots in the middle, so cuts are beside it.
                const double at = x.lo + (x.hi - x.lo) * 0.4871;
                if (!(x.lo < at && at < x.hi) || x.hi - x.lo < smallest * (span_.hi - span_.lo))
                    return std::nullopt;
                open.emplace_back(at, x.hi);
                open.emplace_back(x.lo, at);
            }
            if (is_unclear_ || asked_ > most_asked) return std::nullopt;
        }
        return std::move(found_);
    }

private:
    static constexpr int most_asked = 20'000;
    static constexpr double smallest = 1e-9, narrow = 1e-16; // parts of the span

    Slope over(Interval x) {
        ++asked_;
        return function_(x);
    }
    // Newton's operator: it holds all roots in x. The slope over x must not hold 0.
    Interval newton(Interval x, Interval slope) {
        const double m = mid(x);
        return Interval(m) - over(Interval(m)).value / slope;
    }
    static bool is_inside(Interval a, Interval b) { return b.lo < a.lo && a.hi < b.hi; }
    static bool is_bounded(Interval a) { return !std::isinf(magnitude(a)); }

    // False if the interval must be divided.
    bool settle(Interval x) {
        const Slope f = over(x);
        if (!contains(f.value, 0.0)) return true;
        if (!is_bounded(f.slope)) return false;
        const double m = mid(x);
        const Interval by_slope = over(Interval(m)).value + f.slope * (x - Interval(m));
        if (!contains(by_slope, 0.0)) return true;
        if (contains(f.slope, 0.0)) return false;
        // The function is monotone, and has one root if it is on both sides of 0.
        if (const Interval image = newton(x, f.slope); is_inside(image, x)) {
            add(image, x);
            return true;
        }
        const Interval first = over(Interval(x.lo)).value, last = over(Interval(x.hi)).value;
        if (!contains(first, 0.0) && !contains(last, 0.0)) {
            if ((first.lo > 0) != (last.lo > 0)) add(x, x);
            return true;
        }
        // A root may lie at an end of x, or a little beyond it.
        const double margin = 0.1 * (x.hi - x.lo);
        const Interval wide{x.lo - margin, x.hi + margin};
        const Slope around = over(wide);
        if (!is_bounded(around.slope) || contains(around.slope, 0.0)) return false;
        const Interval image = newton(wide, around.slope);
        if (!is_inside(image, wide)) return false;
        add(image, wide);
        return true;
    }

    void add(Interval where, Interval alone) {
        // A root at 0 would be narrowed until only arithmetic of a thousand bits proves it again.
        while (where.hi - where.lo > narrow * (span_.hi - span_.lo)) {
            const Slope f = over(where);
            if (contains(f.slope, 0.0)) break;
            const Interval next = intersect(where, newton(where, f.slope));
            const bool shrinks = next.hi - next.lo < 0.8 * (where.hi - where.lo);
            where = next;
            if (!shrinks) break;
        }
        // Two intervals next to each other may both have found it.
        if (!found_.empty() && found_.back().where.hi >= where.lo) {
            is_unclear_ |=
                !contains(found_.back().alone, where) && !contains(alone, found_.back().where);
            return;
        }
        found_.push_back({where, alone});
    }

    Function& function_;
    Interval span_;
    std::vector<Root> found_;
    int asked_ = 0;
    bool is_unclear_ = false;
};

template<class Function>
std::optional<std::vector<Root>> roots(Function&& function, Interval span) {
    return Roots(function, span).find();
}

// The inputs below each node, one bit each; of those from the last on one for all.
std::vector<std::uint32_t> inputs_below(const Graph& g, NodeId root) {
    std::vector<std::uint32_t> inputs(g.size(), 0);
    for (const NodeId id : formula::nodes_below(g, std::array{root})) {
        const Node& node = g[id];
        if (node.op == Op::input) inputs[id] = 1U << std::min(node.index, 31);
        for (std::size_t k = 0; k < node.arity; ++k) inputs[id] |= inputs[node.children[k]];
    }
    return inputs;
}

class Parting {
public:
    Parting(Graph& graph, NodeId root, std::size_t inputs)
        : g_(graph)
        , inputs_(inputs_below(graph, root))
        , terms_(inputs, graph.constant(0)) {}

    // Adds `factor` times the node to the terms. False if it is no sum of them.
    bool add(NodeId id, NodeId factor) {
        const Node node = g_[id];
        const std::uint32_t inputs = inputs_[id];
        if (std::popcount(inputs) <= 1) {
            const std::size_t which =
                inputs == 0 ? terms_.size() - 1 : std::size_t(std::countr_zero(inputs));
            if (which >= terms_.size()) return false;
            terms_[which] = g_.add(terms_[which], g_.multiply(factor, id));
            return true;
        }
        const auto [a, b, c, d] = node.children;
        switch (node.op) {
        case Op::add:
            return add(a, factor) && add(b, factor);
        case Op::subtract:
            return add(a, factor) && add(b, g_.unary(Op::negate, factor));
        case Op::negate:
            return add(a, g_.unary(Op::negate, factor));
        case Op::multiply:
            if (inputs_[a] == 0) return add(b, g_.multiply(factor, a));
            if (inputs_[b] == 0) return add(a, g_.multiply(factor, b));
            return false;
        default: // a division is cut off where it is large, and so not linear
            return false;
        }
    }

    std::vector<NodeId> terms() && { return std::move(terms_); }

private:
    Graph& g_;
    std::vector<std::uint32_t> inputs_;
    std::vector<NodeId> terms_;
};

} // namespace

std::optional<std::vector<NodeId>> separated(Graph& graph, NodeId root, std::size_t inputs) {
    graph.fold_exactly();
    const NodeId one = graph.constant(1);
    Parting parting(graph, root, inputs);
    if (!parting.add(root, one)) return std::nullopt;
    return std::move(parting).terms();
}

Term::Term(Graph graph, NodeId root, std::size_t input, const formula::Bindings<Interval>& bindings)
    : bindings_(bindings)
    , program_(formula::schedule(graph, jet_over_boxes(graph, root, std::array{input}, 1)))
    , evaluator_(program_)
    , inputs_(input + 1) {}

Term::Over Term::over(Interval x) {
    inputs_.back() = x;
    std::array<Interval, 3> jet;
    evaluator_.point(bindings_, inputs_, jet);
    return {jet[0], jet[1], jet[2]};
}

std::optional<std::vector<Root>> stationary_points(Term& term, Interval span) {
    return roots(
        [&](Interval x) {
            const Term::Over f = term.over(x);
            return Slope{f.slope, f.second};
        },
        span);
}

std::optional<std::vector<Root>> zeros(Term& term, Interval c, Interval span) {
    return roots(
        [&](Interval x) {
            const Term::Over f = term.over(x);
            return Slope{f.value + c, f.slope};
        },
        span);
}

} // namespace isomotion::topology
