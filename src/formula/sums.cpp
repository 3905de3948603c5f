#include "formula/sums.h"

#include <algorithm>

#include <fmt/format.h>

#include "formula/glsl_interval.h"

namespace isomotion::formula {
namespace {

std::vector<NodeId> sums_below(const Graph& graph, NodeId root) {
    std::vector<NodeId> stack{root}, found;
    std::vector<bool> seen(graph.size(), false);
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (seen[id]) continue;
        seen[id] = true;
        const Node& node = graph[id];
        if (node.op == Op::sum) found.push_back(id);
        for (int k = 0; k < node.arity; ++k) stack.push_back(node.children[std::size_t(k)]);
    }
    std::sort(found.begin(), found.end());
    return found;
}

// ", out vec2 s0, out vec2 s1"
std::string sum_parameters(int count) {
    std::string text;
    for (int k = 0; k < count; ++k) text += fmt::format(", out vec2 s{}", k);
    return text;
}

std::vector<std::string> sum_names(int count) {
    std::vector<std::string> names;
    for (int k = 0; k < count; ++k) names.push_back(fmt::format("s{}", k));
    return names;
}

} // namespace

std::optional<Sums> sums_of(const Field& field) {
    const std::vector<NodeId> found = sums_below(field.graph, field.root);
    if (field.packing.size() != 1 || found.empty() || found.size() > 4) return std::nullopt;
    std::vector<NodeId> with_field{field.root}, bodies;
    for (const NodeId id : found) {
        const NodeId body = field.graph[id].children[0];
        if (!sums_below(field.graph, body).empty()) return std::nullopt;
        with_field.push_back(id);
        bodies.push_back(body);
    }
    return Sums{schedule(field.graph, with_field), schedule(field.graph, bodies, 1u << Sums::array),
                int(found.size())};
}

std::string glsl_field_and_sums_interval(const Sums& sums, const ArrayPacking& packing) {
    IntervalSignature signature{"void field_and_sums_interval(vec2 x, vec2 y, vec2 z, out vec2 f" +
                                    sum_parameters(sums.count) + ")",
                                {"x", "y", "z"},
                                "",
                                sum_names(sums.count)};
    signature.outputs.insert(signature.outputs.begin(), "f");
    return emit_interval_glsl(sums.with_field, signature, packing);
}

std::string glsl_terms_interval(const Sums& sums, const ArrayPacking& packing) {
    std::string head =
        "void terms_interval(int e0, vec2 x, vec2 y, vec2 z" + sum_parameters(sums.count) + ") {\n";
    const std::size_t texels = (packing[Sums::array].size() + 3) / 4;
    for (std::size_t t = 0; t < texels; ++t) {
        head += fmt::format("    vec4 a0_{0} = array0_texel(e0, {0});\n", t);
    }
    return emit_interval_glsl(sums.terms,
                              {head + "   ", {"x", "y", "z"}, "", sum_names(sums.count)}, packing) +
           "}\n";
}

} // namespace isomotion::formula
