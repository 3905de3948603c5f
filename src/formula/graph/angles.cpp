#include "formula/graph/angles.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace isomotion::formula {
namespace {

constexpr std::size_t most_looked_at = 64; // nodes of an argument

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double least_exact = 0x1p-900;

double exact_product(double a, double b) {
    const double product = a * b;
    const bool is_exact = std::abs(product) > least_exact && std::fma(a, b, -product) == 0;
    return is_exact ? product : not_known;
}
double exact_quotient(double a, double b) {
    const double quotient = a / b;
    const bool is_exact = std::abs(a) > least_exact && std::abs(quotient) > least_exact &&
                          std::fma(quotient, b, -a) == 0;
    return is_exact ? quotient : not_known;
}

// What a node is a sum of, with constant factors.
std::span<const NodeId> summands(const Graph& g, const Node& node) {
    const std::span<const NodeId> all = std::span(node.children).first(node.arity);
    switch (node.op) {
    case Op::negate:
    case Op::add:
    case Op::subtract:
        return all;
    case Op::multiply: // a constant comes first
        return g.is_constant(all[0]) ? all.subspan(1) : all.first(0);
    case Op::divide:
        return g.is_constant(all[1]) ? all.first(1) : all.first(0);
    default:
        return all.first(0);
    }
}

// Whether an atan2 is among the summands; false, too, where there are very many.
bool has_cut(const Graph& g, NodeId argument) {
    std::set<NodeId> seen{argument};
    std::vector<NodeId> open{argument};
    bool found = false;
    while (!open.empty()) {
        const Node& node = g[open.back()];
        open.pop_back();
        found = found || node.op == Op::atan2;
        for (const NodeId one : summands(g, node)) {
            if (seen.insert(one).second) open.push_back(one);
        }
        if (seen.size() > most_looked_at) return false;
    }
    return found;
}

class WithoutCuts {
public:
    explicit WithoutCuts(Graph& g)
        : g_(g) {}

    // `periods`: by how many periods of the wave its argument changes where this node changes by a
    // turn.
    NodeId of(NodeId id, double periods) {
        if (std::isnan(periods)) return id;
        if (const auto known = known_.find({id, periods}); known != known_.end())
            return known->second;
        const NodeId made = make(id, periods);
        known_[{id, periods}] = made;
        return made;
    }

private:
    NodeId make(NodeId id, double periods) {
        const Node node = g_[id]; // a copy: the graph grows
        const auto [a, b, c, d] = node.children;
        if (node.op == Op::atan2)
            return periods == std::floor(periods) ? g_.binary(Op::angle, a, b) : id;
        if (summands(g_, node).empty()) return id;
        switch (node.op) {
        case Op::negate: {
            const NodeId now = of(a, periods);
            return now == a ? id : g_.unary(Op::negate, now);
        }
        case Op::multiply: {
            const NodeId now = of(b, exact_product(periods, g_[a].value));
            return now == b ? id : g_.multiply(a, now);
        }
        case Op::divide: {
            const NodeId now = of(a, exact_quotient(periods, g_[b].value));
            return now == a ? id : g_.divide(now, b);
        }
        default: {
            const NodeId left = of(a, periods), right = of(b, periods);
            return left == a && right == b ? id : g_.binary(node.op, left, right);
        }
        }
    }

    Graph& g_;
    std::map<std::pair<NodeId, double>, NodeId> known_;
};

bool is_square_of(const Graph& g, NodeId square, NodeId of) {
    const Node& node = g[square];
    return node.op == Op::multiply && node.children[0] == of && node.children[1] == of;
}

bool is_distance(const Graph& g, NodeId root, NodeId a, NodeId b) {
    if (g[root].op != Op::sqrt) return false;
    const Node& sum = g[g[root].children[0]];
    if (sum.op != Op::add) return false;
    const auto [first, second, c, d] = sum.children;
    return (is_square_of(g, first, a) && is_square_of(g, second, b)) ||
           (is_square_of(g, first, b) && is_square_of(g, second, a));
}

} // namespace

NodeId without_cuts(Graph& g, Op wave, NodeId argument) {
    if (!has_cut(g, argument)) return argument;
    return WithoutCuts(g).of(argument, wave == Op::tan ? 2 : 1);
}

std::optional<NodeId> half_angle(Graph& g, NodeId quotient) {
    const Node node = g[quotient];
    if (node.op != Op::divide || g[node.children[1]].op != Op::add) return std::nullopt;
    const NodeId a = node.children[0];
    const auto [first, second, c, d] = g[node.children[1]].children;
    for (const auto& [root, b] : {std::pair(first, second), std::pair(second, first)}) {
        if (is_distance(g, root, a, b))
            return g.multiply(g.constant(0.5), g.binary(Op::atan2, a, b));
    }
    return std::nullopt;
}

} // namespace isomotion::formula
