#include "formula/element_kernels.h"

#include <algorithm>
#include <array>

#include "formula/graph/continuity.h"
#include "formula/graph/degree.h"
#include "formula/graph/derivative.h"
#include "formula/graph/lowering.h"
#include "formula/graph/substitute.h"
#include "formula/sums_apart.h"

namespace isomotion::formula {
namespace {

// Whether `root` has a coordinate below it when what is below `without` does not count.
bool reads_coordinates(const Graph& graph, NodeId root, NodeId without) {
    std::vector<bool> reads(std::size_t(root) + 1, false);
    for (const NodeId id : nodes_below(graph, std::array{root})) {
        const Node& node = graph[id];
        if (id == without) continue;
        bool any = node.op == Op::input;
        for (std::size_t k = 0; k < node.arity; ++k) any = any || reads[node.children[k]];
        reads[id] = any;
    }
    return reads[root];
}

std::array<NodeId, 3> gradient_of(Graph& graph, NodeId node) {
    const NodeId one = graph.constant(1), zero = graph.constant(0);
    return {differentiate_inputs(graph, node, {one, zero, zero}),
            differentiate_inputs(graph, node, {zero, one, zero}),
            differentiate_inputs(graph, node, {zero, zero, one})};
}

// Along how many axes a polynomial of degree 2 bends, as one that grows along them does; 0 if it
// is linear along one.
int bends(Graph& graph, NodeId node) {
    const std::array<NodeId, 3> first = gradient_of(graph, node);
    int axes = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (graph.is_constant(first[k], 0)) continue;
        if (graph.is_constant(gradient_of(graph, first[k])[k], 0)) return 0;
        ++axes;
    }
    return axes;
}

// The polynomial that a term reads the coordinates through: the deepest one without which it
// reads none, or else the last one of those that bend along most axes.
std::optional<NodeId> quadric_of(Graph& graph, NodeId term) {
    const auto degree_of = degrees(graph, term);
    std::optional<NodeId> last;
    int most = 1;
    for (const NodeId id : nodes_below(graph, std::array{term})) {
        if (degree_of[id] != 2) continue;
        const int axes = bends(graph, id);
        if (axes == 0) continue;
        if (!reads_coordinates(graph, term, id)) return id;
        if (axes < most) continue;
        last = id;
        most = axes;
    }
    return last;
}

// What a term without such a polynomial reads the place through.
struct Shape {
    bool ends = false, is_even = false, is_exponential = false;
};

Shape shape_of(const Graph& graph, NodeId term) {
    Shape shape;
    for (const NodeId id : nodes_below(graph, std::array{term})) {
        const Op op = graph[id].op;
        shape.ends = shape.ends || op == Op::max || op == Op::min || op == Op::select;
        shape.is_even = shape.is_even || op == Op::abs || op == Op::sqrt;
        shape.is_exponential = shape.is_exponential || op == Op::exp;
    }
    return shape;
}

// Whether it may all the same be 0, or nearly, away from its element.
bool may_fade(const Graph& graph, NodeId term) {
    const Shape shape = shape_of(graph, term);
    return shape.ends || (shape.is_even && shape.is_exponential);
}

// Whether such a key may grow away from its element.
bool may_grow(const Graph& graph, NodeId key) {
    const Shape shape = shape_of(graph, key);
    return shape.ends || shape.is_even || degree(graph, key).value_or(0) >= 2;
}

// Q, its gradient and its Hessian where all coordinates are 0.
void add_coefficients(Graph& graph, NodeId quadric, std::vector<NodeId>& all) {
    const std::array<NodeId, 3> first = gradient_of(graph, quadric);
    std::vector<NodeId> found{quadric, first[0], first[1], first[2]};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<NodeId, 3> second = gradient_of(graph, first[i]);
        for (std::size_t j = i; j < 3; ++j) found.push_back(second[j]);
    }
    const auto at_0 = [](Graph& g, const Node& node, NodeId rebuilt) {
        return node.op == Op::input ? g.constant(0) : rebuilt;
    };
    for (const NodeId id : substitute(graph, graph, found, at_0)) all.push_back(id);
}

} // namespace

std::optional<ElementKernels> element_kernels(const Field& field, int array) {
    Graph graph = field.graph;
    const std::vector<NodeId> sums = sums_over(graph, std::array{field.root}, array);
    if (sums.empty() || sums.size() > ElementKernels::most_sums) return std::nullopt;

    ElementKernels kernels;
    kernels.array = array;
    kernels.is_least = graph[sums[0]].op == Op::least;
    if (kernels.is_least && sums.size() > 1) return std::nullopt;
    std::vector<NodeId> quadrics, terms;
    for (const NodeId sum : sums) {
        if (graph[sum].op != (kernels.is_least ? Op::least : Op::sum)) return std::nullopt;
        const NodeId term = graph[sum].children[0];
        std::optional<NodeId> quadric = quadric_of(graph, term);
        if (!quadric) {
            if (!(kernels.is_least ? may_grow : may_fade)(graph, term)) return std::nullopt;
            quadric = graph.constant(0);
        }
        const auto at = std::find(quadrics.begin(), quadrics.end(), *quadric);
        kernels.quadric_of.push_back(int(at - quadrics.begin()));
        if (at == quadrics.end()) quadrics.push_back(*quadric);
        terms.push_back(term);
    }
    kernels.quadrics = int(quadrics.size());

    std::vector<NodeId> coefficients;
    for (const NodeId quadric : quadrics) add_coefficients(graph, quadric, coefficients);
    coefficients = substitute(graph, graph, coefficients, FieldsAsInputs(kernels.fields, array, 0));

    std::vector<NodeId> by_place =
        substitute(graph, graph, terms, FieldsAsInputs(kernels.fields, array, 3));
    for (NodeId& term : by_place) term = with_gaps(graph, term);

    std::vector<Node> replaced;
    replaced.reserve(quadrics.size());
    for (const NodeId quadric : quadrics) replaced.push_back(graph[quadric]);
    terms = substitute(graph, graph, terms, [&](Graph& g, const Node& node, NodeId rebuilt) {
        if (node.op == Op::constant) return rebuilt;
        const auto at = std::find(replaced.begin(), replaced.end(), node);
        return at == replaced.end() ? rebuilt : g.input(3 + int(at - replaced.begin()));
    });
    terms = substitute(graph, graph, terms,
                       FieldsAsInputs(kernels.fields, array, kernels.first_field()));
    // Terms without a value are not small.
    for (NodeId& term : terms) term = with_gaps(graph, term);

    kernels.terms = schedule(graph, terms);
    kernels.by_place = schedule(graph, by_place);
    kernels.read_places =
        std::ranges::any_of(kernels.terms.instructions, [](const Instruction& now) {
            return now.kind == Instruction::Kind::operation && now.op == Op::input && now.index < 3;
        });
    kernels.coefficients = schedule(graph, lower(graph, coefficients));
    return kernels;
}

} // namespace isomotion::formula
