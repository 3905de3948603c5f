#include "formula/element_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "formula/graph/substitute.h"
#include "formula/graph/vocabulary.h"

namespace isomotion::formula {
namespace {

// A product by its factors and their powers; those of divisors are below 0. Constants and signs are
// left out. Doubles: powers of powers go beyond any integer.
using Factors = std::map<NodeId, double>;

Factors factors_of(const Graph& graph, NodeId product) {
    Factors open{{product, 1.0}}, factors;
    while (!open.empty()) {
        const auto [id, power] = *std::prev(open.end()); // whatever it is a factor of has been seen
        open.erase(id);
        const Node& node = graph[id];
        switch (node.op) {
        case Op::constant:
            break;
        case Op::negate:
        case Op::abs:
            open[node.children[0]] += power;
            break;
        case Op::multiply:
            open[node.children[0]] += power;
            open[node.children[1]] += power;
            break;
        case Op::divide:
            open[node.children[0]] += power;
            open[node.children[1]] -= power;
            break;
        default:
            factors[id] += power;
        }
    }
    return factors;
}

// For each node, whether it reads a coordinate.
std::vector<bool> readers_of_place(const Graph& graph) {
    std::vector<bool> reads(graph.size(), false);
    for (NodeId id = 0; id < graph.size(); ++id) {
        const Node& node = graph[id];
        bool any = node.op == Op::input && node.index < int(coordinate_names.size());
        for (std::size_t k = 0; k < node.arity; ++k) any = any || reads[node.children[k]];
        reads[id] = any;
    }
    return reads;
}

// What a factor changes with.
struct Readers {
    explicit Readers(const Graph& of)
        : graph(of)
        , place(readers_of_place(of)) {}

    bool is_of_elements(NodeId id) const { return graph[id].arrays != 0; }
    // Tells near elements from far ones.
    bool is_of_both(NodeId id) const { return place[id] && is_of_elements(id); }

    const Graph& graph;
    std::vector<bool> place;
};

// Whether two terms are alike but for factors that are the same everywhere or for all elements.
bool are_alike(Factors a, const Factors& b, const Readers& readers) {
    for (const auto& [id, power] : b) a[id] -= power;
    return std::ranges::all_of(a, [&](const auto& factor) {
        return factor.second == 0 || !readers.is_of_both(factor.first);
    });
}

// Whether a term has all factors of a field's that change: where one of them makes the field's
// small, the other must be.
bool holds(const Factors& term, const Factors& of_field, const Readers& readers) {
    return std::ranges::all_of(of_field, [&](const auto& factor) {
        const auto [id, power] = factor;
        if (!readers.place[id] && !readers.is_of_elements(id)) return true;
        const auto found = term.find(id);
        if (found == term.end()) return false;
        return found->second == power || (power > 0 && found->second > power);
    });
}

double count(const Factors& factors) {
    double all = 0;
    for (const auto& [id, power] : factors) all += std::abs(power);
    return all;
}

// The terms of sums over the array that lie in no other sum, in the order of the formula.
std::vector<NodeId> terms_over(const Graph& graph, NodeId root, int array) {
    std::vector<NodeId> terms;
    for (const NodeId id : nodes_below(graph, std::array{root})) {
        const Node& node = graph[id];
        if (node.op == Op::sum && node.index == array && node.arrays == 0)
            terms.push_back(node.children[0]);
    }
    return terms;
}

// Whether the field asks for the same least element, and reads the place in no other way: then its
// roots are where the least is a number, and all that are less there are known.
bool holds_least(const Graph& graph, NodeId field, const Node& asked) {
    std::vector<bool> reads(std::size_t(field) + 1, false);
    bool asks = false;
    for (const NodeId id : nodes_below(graph, std::array{field})) {
        const Node& node = graph[id];
        const bool is_same = node.op == Op::least && node.index == asked.index &&
                             node.children[0] == asked.children[0];
        asks = asks || is_same;
        bool any = node.op == Op::input;
        for (std::size_t k = 0; k < node.arity; ++k) any = any || reads[node.children[k]];
        reads[id] = any && !is_same;
    }
    return asks && !reads[field];
}

} // namespace

std::optional<NodeId> element_weight(const Graph& graph, NodeId field, int array) {
    const std::vector<NodeId> terms = terms_over(graph, field, array);
    if (terms.empty()) return std::nullopt;
    const Readers readers(graph);
    const Factors first = factors_of(graph, terms.front());
    NodeId weight = terms.front();
    double fewest = count(first);
    for (const NodeId term : terms) {
        const Factors factors = factors_of(graph, term);
        if (!(count(factors) < fewest) || !are_alike(first, factors, readers)) continue;
        weight = term;
        fewest = count(factors);
    }
    return weight;
}

std::optional<NodeId> least_key(const Graph& graph, NodeId field, int array) {
    for (const NodeId id : nodes_below(graph, std::array{field})) {
        const Node& node = graph[id];
        if (node.op == Op::least && node.index == array && node.arrays == 0)
            return node.children[0];
    }
    return std::nullopt;
}

bool weigh_like_field(const Graph& graph, NodeId field, std::span<const NodeId> roots, int array) {
    const Readers readers(graph);
    std::vector<Factors> of_field;
    for (const NodeId term : terms_over(graph, field, array))
        of_field.push_back(factors_of(graph, term));
    return std::ranges::all_of(nodes_below(graph, roots), [&](NodeId id) {
        const Node& node = graph[id];
        if (!is_over_elements(node.op) || node.index != array) return true;
        if (node.op != Op::sum) return holds_least(graph, field, node);
        const Factors term = factors_of(graph, node.children[0]);
        return std::ranges::any_of(of_field, [&](const Factors& known) {
            return are_alike(term, known, readers) && holds(term, known, readers);
        });
    });
}

} // namespace isomotion::formula
