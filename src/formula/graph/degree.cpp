#include "formula/graph/degree.h"

#include <algorithm>

namespace isomotion::formula {
namespace {

constexpr int highest = 1 << 20;
constexpr int no_polynomial = -1;

// The degree of a node, from those of its children, which are polynomials.
int degree_of(const Node& node, const std::array<int, 4>& children) {
    const auto [a, b, c, d] = children;
    switch (node.op) {
    case Op::constant:
    case Op::parameter:
    case Op::element:
        return 0;
    case Op::input:
        return 1;
    case Op::negate:
    case Op::sum:
        return a;
    case Op::add:
    case Op::subtract:
        return std::max(a, b);
    case Op::multiply:
        return std::min(a + b, highest);
    case Op::chebyshev:
        return int(std::min<long long>(1LL * std::max(node.index - node.second, 0) * a, highest));
    case Op::divide:
        return b == 0 ? a : no_polynomial;
    default:
        return std::max({a, b, c, d}) == 0 ? 0 : no_polynomial;
    }
}

} // namespace

std::vector<std::optional<int>> degrees(const Graph& graph, NodeId root) {
    std::vector<std::optional<int>> all(root + 1);
    for (NodeId id = 0; id <= root; ++id) { // children come before parents
        const Node& node = graph[id];
        std::array<int, 4> children{};
        bool polynomials = true;
        for (std::size_t k = 0; k < node.arity; ++k) {
            const auto& child = all[node.children[k]];
            polynomials = polynomials && child;
            if (child) children[k] = *child;
        }
        const int found = polynomials ? degree_of(node, children) : no_polynomial;
        if (found != no_polynomial) all[id] = found;
    }
    return all;
}

std::optional<int> degree(const Graph& graph, NodeId root) { return degrees(graph, root).back(); }

} // namespace isomotion::formula
