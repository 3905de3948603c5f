#include "formula/linear_sum.h"

#include <map>

#include <fmt/format.h>

#include "formula/glsl_interval.h"

namespace isomotion::formula {
namespace {

// Takes an expression apart into factor * sum + rest.
class Splitter {
public:
    Splitter(Graph& graph, NodeId sum)
        : graph_(graph)
        , sum_(sum)
        , zero_(graph.constant(0)) {}

    struct Parts {
        NodeId rest, factor;
    };

    std::optional<Parts> split(NodeId id) {
        if (id == sum_) return Parts{zero_, graph_.constant(1)};
        if (!holds_sum(id)) return Parts{id, zero_};
        const Node node = graph_[id]; // a copy: the graph grows
        const auto a = split(node.children[0]);
        if (!a) return std::nullopt;
        if (node.op == Op::negate) {
            return Parts{graph_.unary(Op::negate, a->rest), graph_.unary(Op::negate, a->factor)};
        }
        if (node.arity != 2) return std::nullopt;
        const auto b = split(node.children[1]);
        if (!b) return std::nullopt;
        switch (node.op) {
        case Op::add:
        case Op::subtract:
            return Parts{graph_.binary(node.op, a->rest, b->rest),
                         graph_.binary(node.op, a->factor, b->factor)};
        case Op::multiply:
            if (!holds_sum(node.children[1])) return scaled(Op::multiply, *a, b->rest);
            if (!holds_sum(node.children[0])) return scaled(Op::multiply, *b, a->rest);
            return std::nullopt;
        case Op::divide:
            if (!holds_sum(node.children[1])) return scaled(Op::divide, *a, b->rest);
            return std::nullopt;
        default:
            return std::nullopt;
        }
    }

private:
    Parts scaled(Op op, const Parts& parts, NodeId by) {
        return {graph_.binary(op, parts.rest, by), graph_.binary(op, parts.factor, by)};
    }

    bool holds_sum(NodeId id) {
        if (id == sum_) return true;
        if (const auto it = holds_.find(id); it != holds_.end()) return it->second;
        const Node node = graph_[id];
        bool holds = false;
        for (int k = 0; k < node.arity; ++k) holds |= holds_sum(node.children[std::size_t(k)]);
        return holds_[id] = holds;
    }

    Graph& graph_;
    NodeId sum_, zero_;
    std::map<NodeId, bool> holds_;
};

std::set<NodeId> sums_below(const Graph& graph, NodeId root) {
    std::vector<NodeId> stack{root};
    std::set<NodeId> seen, found;
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (!seen.insert(id).second) continue;
        const Node& node = graph[id];
        if (node.op == Op::sum) found.insert(id);
        for (int k = 0; k < node.arity; ++k) stack.push_back(node.children[std::size_t(k)]);
    }
    return found;
}

} // namespace

std::optional<LinearSum> linear_sum(const Field& field) {
    const std::set<NodeId> sums = sums_below(field.graph, field.root);
    if (field.packing.size() != 1 || sums.size() != 1) return std::nullopt;
    Graph graph = field.graph;
    const auto parts = Splitter(graph, *sums.begin()).split(field.root);
    if (!parts) return std::nullopt;
    const NodeId body = graph[*sums.begin()].children[0];
    return LinearSum{schedule(graph, std::array{parts->rest, parts->factor}),
                     schedule(graph, std::array{body}, 1u << LinearSum::array)};
}

std::string glsl_rest_and_factor_interval(const LinearSum& sum, const ArrayPacking& packing) {
    return emit_interval_glsl(
        sum.rest_and_factor,
        {"void rest_and_factor_interval(vec2 x, vec2 y, vec2 z, out vec2 rest, out vec2 factor)",
         {"x", "y", "z"},
         "",
         {"rest", "factor"}},
        packing);
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
