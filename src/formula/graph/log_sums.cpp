#include "formula/graph/log_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "formula/graph/operations.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {

bool LogOfSum::has_largest() const {
    const auto is_never_0 = [](const Exponential& term) {
        const Node& factor = (*term.factor.graph)[term.factor.node];
        return factor.op == Op::constant && factor.value != 0;
    };
    return std::ranges::any_of(terms_, &Exponential::is_one) &&
           std::ranges::all_of(terms_, is_never_0);
}

Term LogOfSum::largest() const {
    Term most = terms_.front().exponent;
    for (const Exponential& term : terms_) most = max(most, term.exponent);
    const double end = Operations<float>::saturation();
    return max(most.number(-end), min(most, most.number(end)));
}

Term LogOfSum::value(Term m) const {
    std::optional<Term> rest;
    for (const Exponential& term : terms_) {
        const Term part = term.factor * (term.exponent - m).of(Op::exp);
        rest = rest ? *rest + part : part;
    }
    return m + rest->of(Op::log);
}

void LogOfSum::add_terms(Term a, double sign) {
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

LogOfSum::Exponential LogOfSum::exponential(Term a) {
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
        return is_exponential ? Exponential{a.number(1), std::log(base.value) * second} : itself;
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
