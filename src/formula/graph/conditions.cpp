#include "formula/graph/conditions.h"

#include <unordered_map>

namespace isomotion::formula {
namespace {

// a < b ? then : otherwise
NodeId choice(Graph& g, NodeId a, NodeId b, NodeId then, NodeId otherwise) {
    if (then == a && otherwise == b) return g.binary(Op::min, a, b);
    if (then == b && otherwise == a) return g.binary(Op::max, a, b);
    const auto is_negative_of = [&](NodeId one, NodeId other) {
        return g[one].op == Op::negate && g[one].children[0] == other;
    };
    const bool by_sign = (g.is_constant(b, 0) && otherwise == a && is_negative_of(then, a)) ||
                         (g.is_constant(a, 0) && then == b && is_negative_of(otherwise, b));
    if (by_sign) return g.unary(Op::abs, g.is_constant(b, 0) ? a : b);
    return g.select(a, b, then, otherwise, Op::select);
}

// A condition made of choices, followed to its ends.
class Choosing {
public:
    Choosing(Graph& graph, NodeId a, NodeId b)
        : g_(graph)
        , a_(a)
        , b_(b) {}

    NodeId by(NodeId condition) {
        if (const auto known = made_.find(condition); known != made_.end()) return known->second;
        const Node node = g_[condition]; // a copy: the graph grows
        const NodeId made = g_.is_constant(condition) ? (node.value != 0 ? a_ : b_)
                            : is_condition(g_, condition)
                                ? choice(g_, node.children[0], node.children[1],
                                         by(node.children[2]), by(node.children[3]))
                                : choice(g_, g_.constant(0), g_.unary(Op::abs, condition), a_, b_);
        made_[condition] = made;
        return made;
    }

private:
    Graph& g_;
    NodeId a_, b_;
    std::unordered_map<NodeId, NodeId> made_;
};

// Conditions share parts: each is looked at once.
class Conditions {
public:
    explicit Conditions(const Graph& graph)
        : graph_(graph) {}

    bool has(NodeId id) {
        const Node& node = graph_[id];
        if (node.op == Op::constant) return node.value == 0 || node.value == 1;
        if (!is_choice(node)) return false;
        if (const auto known = known_.find(id); known != known_.end()) return known->second;
        return known_[id] = has(node.children[2]) && has(node.children[3]);
    }

private:
    const Graph& graph_;
    std::unordered_map<NodeId, bool> known_;
};

class Solids {
public:
    explicit Solids(Graph& graph)
        : g_(graph) {}

    NodeId of(NodeId condition) {
        if (const auto known = made_.find(condition); known != made_.end()) return known->second;
        const auto [a, b, then, otherwise] = g_[condition].children;
        const NodeId inside = g_.subtract(a, b); // below 0 where a < b
        const NodeId made = least(where(inside, then), where(g_.subtract(b, a), otherwise), inside,
                                  then, otherwise);
        made_[condition] = made;
        return made;
    }

private:
    // Both: the part's own solid within `where`.
    NodeId where(NodeId where, NodeId part) {
        return g_.is_constant(part) ? where : g_.binary(Op::max, where, of(part));
    }

    // (inside and then) or (outside and otherwise).
    NodeId least(NodeId first, NodeId second, NodeId inside, NodeId then, NodeId otherwise) {
        if (g_.is_constant(otherwise, 0)) return first;
        if (g_.is_constant(then, 0)) return second;
        if (g_.is_constant(then, 1)) return g_.binary(Op::min, inside, of(otherwise));
        if (g_.is_constant(otherwise, 1))
            return g_.binary(Op::min, g_.unary(Op::negate, inside), of(then));
        return g_.binary(Op::min, first, second);
    }

    Graph& g_;
    std::unordered_map<NodeId, NodeId> made_;
};

} // namespace

bool is_choice(const Node& node) { return node.op == Op::select && Op(node.index) == Op::select; }

NodeId is_less(Graph& graph, NodeId a, NodeId b) {
    return choice(graph, a, b, graph.constant(1), graph.constant(0));
}

NodeId is_at_most(Graph& graph, NodeId a, NodeId b) {
    return choice(graph, b, a, graph.constant(0), graph.constant(1));
}

NodeId choose(Graph& graph, NodeId condition, NodeId a, NodeId b) {
    return Choosing(graph, a, b).by(condition);
}

bool is_condition(const Graph& graph, NodeId id) { return Conditions(graph).has(id); }

NodeId solid_of(Graph& graph, NodeId condition) { return Solids(graph).of(condition); }

} // namespace isomotion::formula
