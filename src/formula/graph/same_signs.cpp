#include "formula/graph/same_signs.h"

#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

#include "formula/graph/degree.h"
#include "formula/graph/sign.h"

namespace isomotion::formula {
namespace {

// Nodes may be shared: each is looked at once.
class Simplification {
public:
    Simplification(Graph& graph, NodeId root)
        : graph_(graph)
        , is_positive_(positives(graph, root)) {}

    NodeId without_factors(NodeId id) { return once(left_, id, &Simplification::leave_out); }

private:
    template<class T> using Known = std::unordered_map<NodeId, T>;

    template<class T> T once(Known<T>& known, NodeId id, T (Simplification::*find)(NodeId)) {
        if (const auto found = known.find(id); found != known.end()) return found->second;
        const T now = (this->*find)(id);
        known.emplace(id, now);
        return now;
    }

    bool may_be_left_out(NodeId factor) {
        return !graph_.is_constant(factor) && is_positive_[factor];
    }

    // u of an expression that is exp(u).
    std::optional<NodeId> exponent(NodeId id) {
        return once(exponents_, id, &Simplification::find_exponent);
    }

    std::optional<NodeId> find_exponent(NodeId id) {
        const Node node = graph_[id];
        if (node.may_have_gaps) return {};
        if (node.op == Op::exp) return node.children[0];
        if (node.op == Op::constant && is_positive_[id])
            return graph_.constant(std::log(node.value));
        if (node.op != Op::multiply) return {};
        const auto a = exponent(node.children[0]), b = exponent(node.children[1]);
        if (!a || !b) return {};
        return graph_.add(*a, *b);
    }

    // What differs as these two do, if both are the same growing function of something. A tanh
    // makes a bounded jump of a pole, which may be a wall: so of polynomials only.
    std::optional<NodeId> difference_of_arguments(NodeId a, NodeId b) {
        if (graph_.is_constant(a) || graph_.is_constant(b)) return {};
        const auto of_polynomial = [&](NodeId id) {
            return graph_[id].op == Op::tanh && degree(graph_, graph_[id].children[0]);
        };
        if (of_polynomial(a) && of_polynomial(b))
            return graph_.subtract(graph_[a].children[0], graph_[b].children[0]);
        const auto u = exponent(a), v = exponent(b);
        if (!u || !v) return {};
        return graph_.subtract(*u, *v);
    }

    NodeId leave_out(NodeId id) {
        const Node node = graph_[id]; // the graph grows
        const auto [a, b, c, d] = node.children;
        switch (node.op) {
        case Op::negate:
            return graph_.unary(Op::negate, without_factors(a));
        case Op::multiply:
            if (may_be_left_out(a)) return without_factors(b);
            if (may_be_left_out(b)) return without_factors(a);
            return graph_.multiply(without_factors(a), without_factors(b));
        case Op::divide:
            if (may_be_left_out(b)) return without_factors(a);
            return graph_.divide(without_factors(a), b);
        case Op::subtract:
            return difference_of_arguments(a, b).value_or(id);
        default:
            return id;
        }
    }

    Graph& graph_;
    std::vector<bool> is_positive_;
    Known<std::optional<NodeId>> exponents_;
    Known<NodeId> left_;
};

} // namespace

NodeId same_signs(Graph& graph, NodeId root) {
    const NodeId found = Simplification(graph, root).without_factors(root);
    return graph.is_constant(found) ? root : found; // a formula without a zero stays as it is
}

} // namespace isomotion::formula
