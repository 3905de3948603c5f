#include "formula/graph/log_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

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

// log(sum) of one sum. Nodes may be shared, so that paths are many more: beyond some a part is not
// looked into.
class LogOfSum {
public:
    // Nothing if the sum has no exponentials.
    std::optional<Term> operator()(Term sum) {
        add_terms(sum, 1);
        if (std::ranges::none_of(terms_, &Exponential::is_one)) return {};
        Term most = terms_.front().exponent;
        for (const Exponential& term : terms_) most = max(most, term.exponent);
        std::optional<Term> rest;
        for (const Exponential& term : terms_) {
            const Term part = term.factor * (term.exponent - most).of(Op::exp);
            rest = rest ? *rest + part : part;
        }
        return most + rest->of(Op::log);
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

NodeId with_small_exponents(Graph& graph, NodeId root) {
    bool changes = false;
    const auto replacement = [&changes](Graph& to, const Node& node, NodeId rebuilt) {
        if (node.op != Op::log || to[rebuilt].op != Op::log) return rebuilt;
        const auto found = LogOfSum()({&to, to[rebuilt].children[0]});
        changes = changes || found;
        return found ? found->node : rebuilt;
    };
    const NodeId replaced = substitute(graph, graph, std::array{root}, replacement).front();
    return changes ? replaced : root;
}

bool has_fading_logs(const Graph& graph, NodeId root) {
    const auto any_below = [&](NodeId from, Op op, auto&& holds) {
        return std::ranges::any_of(nodes_below(graph, std::array{from}),
                                   [&](NodeId id) { return graph[id].op == op && holds(id); });
    };
    const auto is_one = [](NodeId) { return true; };
    const auto sums_exponentials = [&](NodeId sum) { return any_below(sum, Op::exp, is_one); };
    return any_below(root, Op::log,
                     [&](NodeId log) { return any_below(log, Op::sum, sums_exponentials); });
}

} // namespace isomotion::formula
