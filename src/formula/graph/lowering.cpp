#include "formula/graph/lowering.h"

#include <bit>
#include <cmath>
#include <unordered_map>

#include "formula/graph/operations.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

struct ChebyshevPair {
    NodeId t; // T_n
    NodeId u; // U_{n-1}
};

// n >= 1.
ChebyshevPair chebyshev_pair(Graph& g, int n, NodeId x) {
    const NodeId one = g.constant(1), two = g.constant(2);
    const NodeId sine2 = g.multiply(g.subtract(one, x), g.add(one, x));
    ChebyshevPair pair{x, one};
    for (int bit = int(std::bit_floor(unsigned(n)) / 2); bit > 0; bit /= 2) {
        pair = {g.subtract(g.multiply(two, g.multiply(pair.t, pair.t)), one),
                g.multiply(two, g.multiply(pair.t, pair.u))};
        if (n & bit) {
            pair = {g.subtract(g.multiply(x, pair.t), g.multiply(sine2, pair.u)),
                    g.add(g.multiply(x, pair.u), pair.t)};
        }
    }
    return pair;
}

NodeId chebyshev_by_halves(Graph& g, int n, NodeId x) {
    if (n == 0) return g.constant(1);
    if (n == 1) return x;
    const NodeId half = chebyshev_by_halves(g, n / 2, x);
    const NodeId other = n % 2 == 0 ? half : chebyshev_by_halves(g, n / 2 + 1, x);
    return g.subtract(g.multiply(g.constant(2), g.multiply(half, other)),
                      n % 2 == 0 ? g.constant(1) : x);
}

// The k-th derivative for k >= 2: 2^(k-1) (k-1)! n C^(k)_{n-k}(x), Gegenbauer by its recurrence.
NodeId chebyshev_derivative(Graph& g, int n, int k, NodeId x) {
    double factor = n;
    for (int j = 1; j < k; ++j) factor *= 2.0 * j;
    NodeId before = g.constant(1);
    if (n == k) return g.constant(factor);
    NodeId now = g.multiply(g.constant(2.0 * k), x);
    for (int m = 2; m <= n - k; ++m) {
        const NodeId ahead = g.multiply(g.constant(2.0 * (m + k - 1) / m), g.multiply(x, now));
        const NodeId behind = g.multiply(g.constant(double(m + 2 * k - 2) / m), before);
        before = now;
        now = g.subtract(ahead, behind);
    }
    return g.multiply(g.constant(factor), now);
}

enum class Products { of_pairs, fewest };

NodeId lower_chebyshev(Graph& g, int n, int k, NodeId a, Products products) {
    NodeId x = a;
    if (n > highest_whole_degree) {
        const NodeId reach = g.constant(chebyshev_reach(n));
        x = g.binary(Op::max, g.unary(Op::negate, reach), g.binary(Op::min, reach, a));
    }
    if (k >= 2) return chebyshev_derivative(g, n, k, x);
    if (k == 0 && products == Products::fewest) return chebyshev_by_halves(g, n, x);
    const ChebyshevPair pair = chebyshev_pair(g, n, x);
    return k == 0 ? pair.t : g.multiply(g.constant(n), pair.u);
}

NodeId lower_one(Graph& g, const Node& node, const std::array<NodeId, 4>& children,
                 Products products) {
    return node.op == Op::chebyshev
               ? lower_chebyshev(g, node.index, node.second, children[0], products)
               : remade(g, node, children);
}

std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots, Products products) {
    const std::size_t count = graph.size();
    std::vector<bool> live(count, false);
    for (const NodeId root : roots) live[root] = true;
    for (NodeId id = NodeId(count); id-- > 0;) {
        if (!live[id]) continue;
        for (int k = 0; k < graph[id].arity; ++k) live[graph[id].children[std::size_t(k)]] = true;
    }
    std::vector<NodeId> lowered(count);
    for (NodeId id = 0; id < count; ++id) {
        lowered[id] = id;
        if (!live[id] || graph[id].arity == 0) continue;
        const Node node = graph[id]; // a copy: the graph grows below
        std::array<NodeId, 4> children = node.children;
        bool changed = node.op == Op::chebyshev;
        for (int k = 0; k < node.arity; ++k) {
            NodeId& child = children[std::size_t(k)];
            changed = changed || lowered[child] != child;
            child = lowered[child];
        }
        if (changed) lowered[id] = lower_one(graph, node, children, products);
    }
    std::vector<NodeId> result;
    for (const NodeId root : roots) result.push_back(lowered[root]);
    return result;
}

} // namespace

double chebyshev_reach(int n) {
    const double limit = double(Operations<float>::saturation()) / std::pow(n, 4);
    return std::cosh(std::acosh(limit) / n);
}

std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots) {
    return lower(graph, roots, Products::of_pairs);
}

NodeId lower_to_fewest_products(Graph& graph, NodeId root) {
    return lower(graph, std::array{root}, Products::fewest).front();
}

Program schedule_lowered(Graph& graph, NodeId root) {
    return schedule(graph, lower(graph, std::array{root}));
}

} // namespace isomotion::formula
