#include "formula/linear_sum.h"

#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

// Takes an expression apart into factor * sum + rest, node by node from the leaves on: chains of a
// formula are longer than a stack, and what many nodes share is taken apart once.
class Splitter {
public:
    struct Parts {
        NodeId rest, factor;
    };

    Splitter(Graph& graph, NodeId sum)
        : graph_(graph)
        , sum_(sum) {}

    std::optional<Parts> split(NodeId root) {
        const std::vector<NodeId> below = nodes_below(graph_, std::array{root});
        for (const NodeId id : below) {
            const Node node = graph_[id]; // a copy: the graph grows
            if (id == sum_) {
                parts_.emplace(id, Parts{graph_.constant(0), graph_.constant(1)});
            } else if (holds_sum(node)) {
                const auto parts = parts_of(node);
                if (!parts) return std::nullopt;
                parts_.emplace(id, *parts);
            }
        }
        return parts_.at(root);
    }

private:
    bool holds_sum(NodeId id) const { return parts_.count(id) > 0; }
    bool holds_sum(const Node& node) const {
        for (std::size_t k = 0; k < node.arity; ++k) {
            if (holds_sum(node.children[k])) return true;
        }
        return false;
    }

    // Parts of a child: without the sum below it, all is rest.
    Parts parts_of(NodeId child) {
        return holds_sum(child) ? parts_.at(child) : Parts{child, graph_.constant(0)};
    }

    std::optional<Parts> parts_of(const Node& node) {
        const NodeId left = node.children[0], right = node.children[1];
        switch (node.op) {
        case Op::negate: {
            const Parts a = parts_of(left);
            return Parts{graph_.unary(Op::negate, a.rest), graph_.unary(Op::negate, a.factor)};
        }
        case Op::add:
        case Op::subtract: {
            const Parts a = parts_of(left), b = parts_of(right);
            return Parts{graph_.binary(node.op, a.rest, b.rest),
                         graph_.binary(node.op, a.factor, b.factor)};
        }
        case Op::multiply:
            if (!holds_sum(right)) return scaled(Op::multiply, parts_of(left), right);
            if (!holds_sum(left)) return scaled(Op::multiply, parts_of(right), left);
            return std::nullopt;
        case Op::divide:
            if (!holds_sum(right)) return scaled(Op::divide, parts_of(left), right);
            return std::nullopt;
        default:
            return std::nullopt;
        }
    }

    Parts scaled(Op op, const Parts& parts, NodeId by) {
        return {graph_.binary(op, parts.rest, by), graph_.binary(op, parts.factor, by)};
    }

    Graph& graph_;
    NodeId sum_;
    std::map<NodeId, Parts> parts_; // of the nodes that hold the sum
};

std::set<NodeId> sums_below(const Graph& graph, NodeId root) {
    std::vector<NodeId> stack{root};
    std::set<NodeId> seen, found;
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (!seen.insert(id).second) continue;
        const Node& node = graph[id];
        if (is_over_elements(node.op)) found.insert(id);
        for (int k = 0; k < node.arity; ++k) stack.push_back(node.children[std::size_t(k)]);
    }
    return found;
}

} // namespace

std::optional<LinearSum> linear_sum(const Field& field) {
    const std::set<NodeId> sums = sums_below(field.graph, field.root);
    if (field.packing.size() != 1 || sums.size() != 1) return std::nullopt;
    if (field.graph[*sums.begin()].op != Op::sum) return std::nullopt;
    Graph graph = field.graph;
    const auto parts = Splitter(graph, *sums.begin()).split(field.root);
    if (!parts) return std::nullopt;
    const NodeId body = graph[*sums.begin()].children[0];
    return LinearSum{schedule(graph, std::array{parts->rest, parts->factor}),
                     schedule(graph, std::array{body}, 1u << LinearSum::array)};
}

LinearSum known_linear_sum(const Field& field) {
    auto sum = linear_sum(field);
    if (!sum) throw std::logic_error("lists of elements for a field that is no linear sum");
    return std::move(*sum);
}

std::string glsl_rest_and_factor_interval(const LinearSum& sum, const ArrayPacking& packing,
                                          Numbers numbers) {
    return emit_interval_glsl(
        sum.rest_and_factor,
        {"void rest_and_factor_interval(vec2 x, vec2 y, vec2 z, out vec2 rest, out vec2 factor)",
         {"x", "y", "z"},
         "",
         {"rest", "factor"}},
        packing, numbers);
}

std::string glsl_term_interval(const LinearSum& sum, const ArrayPacking& packing) {
    std::string head = "vec2 term_interval(int e0, vec2 x, vec2 y, vec2 z) {\n";
    const std::size_t texels = (packing[LinearSum::array].size() + 3) / 4;
    for (std::size_t t = 0; t < texels; ++t) {
        head += fmt::format("    vec4 a0_{0} = array0_texel(e0, {0});\n", t);
    }
    return emit_interval_glsl(sum.term, {head + "   ", {"x", "y", "z"}, "vec2", {}}, packing) +
           "}\n";
}

} // namespace isomotion::formula
