#include "formula/graph/repeated_terms.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

// Noise is as long a text as several other terms.
constexpr std::size_t fewest_terms = 16, terms_of_noise = 4, most_fields = 32, most_arrays_made = 8;
constexpr int most_numbers = 64, most_depth = 64, largest_term = 1000; // of a term, as a tree

// Operations whose operands may be regrouped.
enum class Chain { none, sum, least, greatest };

Chain chain_of(Op op) {
    switch (op) {
    case Op::add:
    case Op::subtract:
    case Op::negate:
        return Chain::sum;
    case Op::min:
        return Chain::least;
    case Op::max:
        return Chain::greatest;
    default:
        return Chain::none;
    }
}

// An operand: a number that may differ between terms, an expression, or a leaf that all share.
struct Operand {
    enum class Kind { number, expression, leaf } kind = Kind::number;
    double number = 0;
    NodeId node = 0;
};

// A node as terms are compared by it. x and x - 0.5 are both a number plus x.
struct Form {
    Op op = Op::constant;
    bool is_square = false; // both operands are one
    std::uint8_t arity = 0;
    std::array<Operand, 4> operands{};
};

// How expressions look but for their numbers. Expressions with the same shape have the same number.
class Shapes {
public:
    Shapes(const Graph& graph, const std::vector<NodeId>& nodes)
        : graph_(graph)
        , known_(graph.size()) {
        for (const NodeId id : nodes) {
            if (!graph.is_constant(id)) look_at(id);
        }
    }

    int shape(NodeId id) const { return known_[id].shape; }
    // Whether terms of its shape can be told by a few numbers.
    bool is_simple(NodeId id) const {
        const Known& known = known_[id];
        return known.numbers <= most_numbers && known.depth <= most_depth &&
               known.nodes <= largest_term;
    }
    const Form& form(NodeId id) const { return known_[id].form; }
    // So many other terms take a driver as long to compile.
    std::size_t terms(NodeId id) const { return known_[id].has_noise ? terms_of_noise : 1; }

    // In an order that is the same for all expressions of a shape.
    std::vector<double> numbers(NodeId id) const {
        std::vector<double> all;
        std::vector<Operand> open{{Operand::Kind::expression, 0, id}};
        while (!open.empty()) {
            const Operand next = open.back();
            open.pop_back();
            if (next.kind == Operand::Kind::number) all.push_back(next.number);
            if (next.kind != Operand::Kind::expression) continue;
            const Form& of = form(next.node);
            for (std::size_t k = of.is_square ? 1 : of.arity; k-- > 0;)
                open.push_back(of.operands[k]);
        }
        return all;
    }

private:
    struct Known {
        Form form;
        int shape = 0, numbers = 0, depth = 0;
        int nodes = 1; // of the tree
        bool has_noise = false;
    };
    using Key = std::tuple<Op, int, int, std::uint64_t, bool, std::vector<int>>;

    Operand operand(NodeId id) const {
        using enum Operand::Kind;
        const Node& node = graph_[id];
        return node.op == Op::constant ? Operand{number, node.value} : Operand{expression, 0, id};
    }

    Form form_of(NodeId id) const {
        using enum Operand::Kind;
        const Node& node = graph_[id];
        const auto [a, b, c, d] = node.children;
        const auto shifted = [&](double by, NodeId of) {
            const auto kind = graph_[of].op == Op::input ? leaf : expression;
            return Form{Op::add, false, 2, {{{number, by}, {kind, 0, of}}}};
        };
        if (node.op == Op::input) return shifted(0, id);
        if (node.op == Op::add && graph_.is_constant(a)) return shifted(graph_[a].value, b);
        if (node.op == Op::subtract && graph_.is_constant(b)) return shifted(-graph_[b].value, a);
        Form form{node.op, node.arity == 2 && a == b, node.arity, {}};
        for (std::size_t k = 0; k < node.arity; ++k) form.operands[k] = operand(node.children[k]);
        // A power with another exponent is defined elsewhere.
        if (node.op == Op::power && graph_.is_constant(b)) form.operands[1] = {leaf, 0, b};
        return form;
    }

    int shape_of(const Operand& operand) {
        using enum Operand::Kind;
        if (operand.kind == number) return 0;
        if (operand.kind == expression) return shape(operand.node);
        const Node& node = graph_[operand.node];
        return number_of(
            {node.op, node.index, 0, std::bit_cast<std::uint64_t>(node.value), false, {}});
    }

    int number_of(const Key& key) {
        return numbers_of_shapes_.try_emplace(key, int(numbers_of_shapes_.size()) + 1)
            .first->second;
    }

    void look_at(NodeId id) {
        const Node& node = graph_[id];
        Known& known = known_[id];
        known.form = form_of(id);
        Form& form = known.form;
        known.has_noise = node.op == Op::noise;
        const auto end = form.operands.begin() + form.arity;
        if (form.op == Op::add || form.op == Op::multiply || chain_of(form.op) > Chain::sum) {
            std::stable_sort(form.operands.begin(), end, [&](const Operand& a, const Operand& b) {
                return shape_of(a) < shape_of(b);
            });
        }
        std::vector<int> shapes;
        for (auto of = form.operands.begin(); of != end; ++of) {
            shapes.push_back(shape_of(*of));
            if (of->kind == Operand::Kind::number) ++known.numbers;
            if (of->kind != Operand::Kind::expression) continue;
            known.has_noise = known.has_noise || known_[of->node].has_noise;
            known.depth = std::max(known.depth, 1 + known_[of->node].depth);
            known.nodes = std::min(largest_term + 1, known.nodes + known_[of->node].nodes);
            if (!form.is_square || of == form.operands.begin())
                known.numbers =
                    std::min(most_numbers + 1, known.numbers + known_[of->node].numbers);
        }
        const bool is_input = node.op == Op::input;
        known.shape = number_of({form.op, is_input ? 0 : node.index, node.second, 0, form.is_square,
                                 std::move(shapes)});
    }

    const Graph& graph_;
    std::vector<Known> known_; // of each node
    std::map<Key, int> numbers_of_shapes_;
};

struct Term {
    double factor = 1;
    NodeId node = 0;
};

class Roller {
public:
    Roller(Graph& graph, NodeId root, int first_array)
        : graph_(graph)
        , root_(root)
        , nodes_(nodes_below(graph, std::array{root}))
        , shapes_(graph, nodes_)
        , first_array_(first_array)
        , blended_(blended_nodes())
        , made_(graph.size()) {}

    RepeatedTerms run() {
        if (nodes_.size() < fewest_terms) return {root_, {}};
        const std::vector<bool> is_end = ends_of_chains();
        for (const NodeId id : nodes_) {
            const Node node = graph_[id]; // a copy: the graph grows
            std::array<NodeId, 4> children{};
            for (std::size_t k = 0; k < node.arity; ++k) children[k] = made_[node.children[k]];
            made_[id] = children == node.children ? id : remade(graph_, node, children);
            if (is_end[id] && node.arrays == 0) made_[id] = rolled(id).value_or(made_[id]);
        }
        return {made_[root_], std::move(arrays_)};
    }

private:
    // Nodes of a chain that no other node of the same takes as an operand: those of the longest
    // chains, since few arrays are made.
    std::vector<bool> ends_of_chains() const {
        std::vector<bool> is_end(graph_.size(), false);
        const auto look = [&](NodeId id, Chain above) {
            const Chain chain = chain_of(graph_[id].op);
            if (chain != Chain::none && chain != above) is_end[id] = true;
        };
        look(root_, Chain::none);
        std::vector<std::size_t> terms(graph_.size(), 1); // of the chain that ends here
        for (const NodeId id : nodes_) {
            const Node& node = graph_[id];
            const Chain chain = chain_of(node.op);
            std::size_t all = 0;
            for (std::size_t k = 0; k < node.arity; ++k) {
                look(node.children[k], chain);
                const bool goes_on = chain_of(graph_[node.children[k]].op) == chain;
                all += goes_on ? terms[node.children[k]] : shapes_.terms(node.children[k]);
            }
            if (chain != Chain::none) terms[id] = std::min(all, terms_of_noise * nodes_.size());
        }
        std::vector<NodeId> ends;
        for (const NodeId id : nodes_) {
            if (is_end[id] && terms[id] >= fewest_terms) ends.push_back(id);
            is_end[id] = false;
        }
        const std::size_t count = std::min(ends.size(), most_arrays_made);
        std::ranges::partial_sort(ends, ends.begin() + std::ptrdiff_t(count), std::greater<>(),
                                  [&](NodeId id) { return terms[id]; });
        for (std::size_t k = 0; k < count; ++k) is_end[ends[k]] = true;
        return is_end;
    }

    // Nodes that a logarithm or a power is taken of, but for factors and what is added.
    std::vector<bool> blended_nodes() const {
        std::vector<bool> blended(graph_.size(), false);
        for (auto id = nodes_.rbegin(); id != nodes_.rend(); ++id) {
            const Node& node = graph_[*id];
            const auto [a, b, c, d] = node.children;
            const bool takes = node.op == Op::log || node.op == Op::power || node.op == Op::sqrt;
            if (takes || (blended[*id] && chain_of(node.op) == Chain::sum)) blended[a] = true;
            if (blended[*id] && chain_of(node.op) == Chain::sum && node.arity == 2)
                blended[b] = true;
            if (blended[*id] && node.op == Op::multiply) blended[a] = blended[b] = true;
            if (blended[*id] && node.op == Op::divide) blended[a] = true;
        }
        return blended;
    }
    // Whether a sum of such terms may leave the range of floats where a power of it does not.
    bool is_steep(NodeId term) const {
        const Op op = graph_[term].op;
        return op == Op::exp || op == Op::power || op == Op::multiply;
    }

    // In the order in which they are written. Empty if there are more than the graph has nodes.
    std::vector<Term> terms(NodeId end) const {
        const Chain chain = chain_of(graph_[end].op);
        std::vector<Term> all, open{{1, end}};
        while (!open.empty() && all.size() <= nodes_.size()) {
            auto [factor, id] = open.back();
            open.pop_back();
            const Node& node = graph_[id];
            const auto [a, b, c, d] = node.children;
            if (chain_of(node.op) == chain) {
                if (node.arity == 2)
                    open.push_back({node.op == Op::subtract ? -factor : factor, b});
                open.push_back({node.op == Op::negate ? -factor : factor, a});
            } else if (chain == Chain::sum && node.op == Op::multiply && graph_.is_constant(a)) {
                all.push_back({factor * graph_[a].value, b});
            } else {
                all.push_back({factor, id});
            }
        }
        if (!open.empty()) all.clear();
        return all;
    }

    std::optional<NodeId> rolled(NodeId end) {
        const Chain chain = chain_of(graph_[end].op);
        const std::vector<Term> all = terms(end);
        std::map<int, std::vector<Term>> groups;
        for (const Term& term : all) {
            if (blended_[end] && is_steep(term.node)) continue;
            if (is_alike(term.node)) groups[shapes_.shape(term.node)].push_back(term);
        }
        std::map<int, NodeId> loops; // by the shape of their terms
        for (const auto& [shape, group] : groups) {
            const std::size_t length = group.size() * shapes_.terms(group.front().node);
            if (length < fewest_terms || arrays_.size() == most_arrays_made ||
                first_array_ + int(arrays_.size()) == max_arrays)
                continue;
            if (const auto loop = loop_over(group, chain)) loops[shape] = *loop;
        }
        if (loops.empty()) return std::nullopt;
        std::optional<NodeId> result;
        const auto join = [&](NodeId next) {
            result = !result                 ? next
                     : chain == Chain::sum   ? graph_.add(*result, next)
                     : chain == Chain::least ? graph_.binary(Op::min, *result, next)
                                             : graph_.binary(Op::max, *result, next);
        };
        for (const Term& term : all) {
            const bool is_in_loop = is_alike(term.node) && loops.contains(shapes_.shape(term.node));
            if (is_in_loop && !(blended_[end] && is_steep(term.node))) continue;
            join(graph_.multiply(graph_.constant(term.factor), made_[term.node]));
        }
        for (const auto& loop : loops) join(loop.second);
        return result;
    }

    // Whether it is compared with others: what holds sums that are rolled already is not.
    bool is_alike(NodeId term) const {
        return !graph_.is_constant(term) && made_[term] == term && shapes_.is_simple(term);
    }

    std::optional<NodeId> loop_over(const std::vector<Term>& group, Chain chain) {
        ElementNumbers columns(1 + shapes_.numbers(group.front().node).size());
        for (const Term& term : group) {
            columns[0].push_back(term.factor);
            const std::vector<double> numbers = shapes_.numbers(term.node);
            for (std::size_t k = 0; k < numbers.size(); ++k) columns[k + 1].push_back(numbers[k]);
        }
        const int array = first_array_ + int(arrays_.size());
        ElementNumbers fields;
        std::vector<NodeId> nodes; // that stand for the columns
        for (const std::vector<double>& column : columns) {
            if (std::ranges::count(column, column.front()) == std::ptrdiff_t(column.size())) {
                nodes.push_back(graph_.constant(column.front()));
                continue;
            }
            const auto place = std::ranges::find(fields, column);
            nodes.push_back(graph_.element(array, int(place - fields.begin())));
            if (place == fields.end()) fields.push_back(column);
        }
        if (fields.empty() || fields.size() > most_fields) return std::nullopt;
        auto next = nodes.cbegin();
        const NodeId factor = *next++;
        const NodeId body = graph_.multiply(factor, with_numbers(group.front().node, next));
        arrays_.push_back(std::move(fields));
        switch (chain) {
        case Chain::sum:
            return graph_.sum(array, body);
        case Chain::least:
            return graph_.least(array, body);
        default:
            return graph_.unary(Op::negate, graph_.least(array, graph_.unary(Op::negate, body)));
        }
    }

    // The expression with other numbers, in the order of Shapes::numbers().
    NodeId with_numbers(NodeId id, std::vector<NodeId>::const_iterator& next) {
        const Form form = shapes_.form(id);
        std::array<NodeId, 4> children{};
        for (std::size_t k = 0; k < form.arity; ++k) {
            const Operand& operand = form.operands[k];
            using enum Operand::Kind;
            children[k] = form.is_square && k == 1     ? children[0]
                          : operand.kind == number     ? *next++
                          : operand.kind == expression ? with_numbers(operand.node, next)
                                                       : operand.node;
        }
        if (form.op == Op::add) return graph_.add(children[0], children[1]);
        const Node node = graph_[id]; // a copy: the graph grows
        return remade(graph_, node, children);
    }

    Graph& graph_;
    NodeId root_;
    std::vector<NodeId> nodes_;
    Shapes shapes_;
    int first_array_;
    std::vector<bool> blended_;
    std::vector<NodeId> made_; // in place of each
    std::vector<ElementNumbers> arrays_;
};

} // namespace

RepeatedTerms repeated_terms(Graph& graph, NodeId root, int first_array) {
    return Roller(graph, root, first_array).run();
}

} // namespace isomotion::formula
