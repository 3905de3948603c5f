#include "formula/graph/log_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "formula/graph/operations.h"
#include "formula/graph/substitute.h"
#include "formula/graph/term.h"

namespace isomotion::formula {
namespace {

// factor * exp(exponent)
struct Exponential {
    Term factor;
    Term exponent;
    bool is_one = true; // otherwise the factor is the entire expression and the exponent 0
};

constexpr int first_largest = 1 << 16; // of the inputs that stand for m

// log(sum) of one sum, where `m` stands for the largest exponent. Nodes may be shared, so that
// paths are many more: beyond some a part is not looked into.
class LogOfSum {
public:
    explicit LogOfSum(Term sum) { add_terms(sum, 1); }

    // Whether there are exponentials, and factors that are never 0: the largest exponential counts
    // then.
    bool has_largest() const {
        const auto is_never_0 = [](const Exponential& term) {
            const Node& factor = (*term.factor.graph)[term.factor.node];
            return factor.op == Op::constant && factor.value != 0;
        };
        return std::ranges::any_of(terms_, &Exponential::is_one) &&
               std::ranges::all_of(terms_, is_never_0);
    }

    // Cut off where floats are, so that no infinite one is subtracted from itself.
    Term largest() const {
        Term most = terms_.front().exponent;
        for (const Exponential& term : terms_) most = max(most, term.exponent);
        const double end = Operations<float>::saturation();
        return max(most.number(-end), min(most, most.number(end)));
    }

    Term value(Term m) const {
        std::optional<Term> rest;
        for (const Exponential& term : terms_) {
            const Term part = term.factor * (term.exponent - m).of(Op::exp);
            rest = rest ? *rest + part : part;
        }
        return m + rest->of(Op::log);
    }

private:
    // Adds `sign` times the terms of a.
    void add_terms(Term a, double sign) {
        const Node node = (*a.graph)[a.node]; // a copy: the graph grows
        const Term first{a.graph, node.children[0]}, second{a.graph, node.children[1]};
        const bool may_look = --left_ >= 0;
        if (may_look && (node.op == Op::add || node.op == Op::subtract)) {
            add_terms(first, sign);
            add_terms(second, node.op == Op::add ? sign : -sign);
        } else if (may_look && node.op == Op::negate) {
            add_terms(first, -sign);
        } else if (node.op == Op::cosh) {
            terms_.push_back({a.number(0.5 * sign), first});
            terms_.push_back({a.number(0.5 * sign), -first});
        } else {
            Exponential term = exponential(a);
            term.factor = sign * term.factor;
            terms_.push_back(term);
        }
    }

    Exponential exponential(Term a) {
        const Node node = (*a.graph)[a.node];
        const Term first{a.graph, node.children[0]}, second{a.graph, node.children[1]};
        const Exponential itself{a, a.number(0), false};
        if (--left_ < 0) return itself;
        switch (node.op) {
        case Op::exp:
            return {a.number(1), first};
        case Op::power: {
            const Node base = (*a.graph)[first.node];
            const bool is_exponential = base.op == Op::constant && base.value > 0;
            return is_exponential ? Exponential{a.number(1), std::log(base.value) * second}
                                  : itself;
        }
        case Op::multiply:
        case Op::divide: {
            const Exponential x = exponential(first), y = exponential(second);
            if (!x.is_one && !y.is_one) return itself;
            const Op of_exponents = node.op == Op::multiply ? Op::add : Op::subtract;
            return {x.factor.with(node.op, y.factor), x.exponent.with(of_exponents, y.exponent)};
        }
        default:
            return itself;
        }
    }

    std::vector<Exponential> terms_;
    int left_ = 256;
};

} // namespace

SmallExponents::SmallExponents(Graph& graph, NodeId root)
    : graph_(graph)
    , root_(root) {
    const auto replacement = [this](Graph& to, const Node& node, NodeId rebuilt) {
        if (node.op != Op::log || to[rebuilt].op != Op::log) return rebuilt;
        if (to[rebuilt].arrays != 0) return rebuilt; // the input that stands for m has none
        const LogOfSum found({&to, to[rebuilt].children[0]});
        if (!found.has_largest()) return rebuilt;
        const Term m{&to, to.input(first_largest + int(largest_.size()))};
        // Those of logarithms within this one are known.
        largest_.push_back(complete(std::array{found.largest().node}).front());
        return found.value(m).node;
    };
    const NodeId replaced = substitute(graph, graph, std::array{root}, replacement).front();
    if (!largest_.empty()) root_ = replaced;
}

std::vector<NodeId> SmallExponents::complete(std::span<const NodeId> roots) const {
    if (largest_.empty()) return {roots.begin(), roots.end()};
    const auto replacement = [this](Graph&, const Node& node, NodeId rebuilt) {
        const bool is_largest = node.op == Op::input && node.index >= first_largest;
        return is_largest ? largest_[std::size_t(node.index - first_largest)] : rebuilt;
    };
    return substitute(graph_, graph_, roots, replacement);
}

bool has_fading_logs(const Graph& graph, NodeId root) {
    // Whether there are exponentials below a node, and whether any of them are summed over
    // elements.
    std::vector<bool> has_some(std::size_t(root) + 1), sums_some(std::size_t(root) + 1);
    for (const NodeId id : nodes_below(graph, std::array{root})) {
        const Node& node = graph[id];
        has_some[id] = node.op == Op::exp;
        for (std::size_t k = 0; k < node.arity; ++k) {
            has_some[id] = has_some[id] || has_some[node.children[k]];
            sums_some[id] = sums_some[id] || sums_some[node.children[k]];
        }
        sums_some[id] = sums_some[id] || (node.op == Op::sum && has_some[id]);
        if (node.op == Op::log && sums_some[id]) return true;
    }
    return false;
}

} // namespace isomotion::formula
