#include "formula/field.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "formula/graph/derivative.h"
#include "formula/graph/in_range.h"
#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"
#include "formula/graph/power_sums.h"
#include "formula/graph/recentred.h"
#include "formula/graph/same_signs.h"
#include "formula/graph/walls.h"
#include "formula/kept_enclosures.h"

namespace isomotion::formula {
namespace {

// All fields that any program reads. They are packed in the order of declaration, so that the
// storage of an array doesn't depend on which derivative reads what.
ArrayPacking packing_of(std::size_t arrays, std::span<const Program* const> programs) {
    std::vector<std::set<int>> used(arrays);
    for (const Program* program : programs) {
        for (const Instruction& now : program->instructions) {
            if (now.kind == Instruction::Kind::operation && now.op == Op::element) {
                used[std::size_t(now.index)].insert(now.second);
            }
        }
    }
    ArrayPacking packing;
    for (const auto& fields : used) packing.emplace_back(fields.begin(), fields.end());
    return packing;
}

void derive_programs(Field& field) {
    Graph& g = field.graph;
    const std::vector<NodeId> direction{g.input(first_direction), g.input(first_direction + 1),
                                        g.input(first_direction + 2)};
    const NodeId one = g.constant(1), zero = g.constant(0);
    const InRange in_range(g, field.root, Purpose::numbers);
    const NodeId root = in_range.root();
    const NodeId along = differentiate_inputs(g, root, direction);
    std::array slopes{differentiate_inputs(g, root, {one, zero, zero}),
                      differentiate_inputs(g, root, {zero, one, zero}),
                      differentiate_inputs(g, root, {zero, zero, one})};
    if (field.wall_distance > 0) slopes = wall_gradient(g, root, field.wall_distance);

    const std::vector<NodeId> all =
        in_range.complete(std::array{root, along, slopes[0], slopes[1], slopes[2]});
    Graph working = g; // lowering adds nodes that only the programs need
    const std::vector<NodeId> low = lower(working, all);
    field.value = schedule(working, std::array{low[0]});
    field.directional = schedule(working, std::array{low[0], low[1]});
    field.gradient = schedule(working, std::array{low[2], low[3], low[4]});
    field.kept = std::make_shared<KeptEnclosures>();
}

} // namespace

Field make_field(std::string_view text, Vocabulary vocabulary,
                 std::vector<ElementNumbers>* repeated, const Origin& origin) {
    Field field;
    field.text = text;
    field.origin = origin;
    vocabulary.inputs = coordinate_names;
    vocabulary.allows_picks = false;
    vocabulary.allows_equation = true;
    NodeId root = parse(text, vocabulary, field.graph);
    field.nodes_read = field.graph.size();
    root = recentred(field.graph, root, origin);
    std::size_t arrays = vocabulary.arrays.size();
    if (repeated) {
        RepeatedTerms terms = repeated_terms(field.graph, root, int(arrays));
        root = terms.root;
        arrays += terms.arrays.size();
        *repeated = std::move(terms.arrays);
    }
    root = same_signs(field.graph, root);
    field.root = norms_without_cut_offs(field.graph, root);
    derive_programs(field);
    field.packing =
        packing_of(arrays, std::array{&field.value, &field.directional, &field.gradient});
    return field;
}

std::string identity(const Field& field) {
    const auto& [x, y, z] = field.origin.point;
    if (x == 0 && y == 0 && z == 0) return field.text;
    return fmt::format("{}, from ({}, {}, {})", field.text, x, y, z);
}

Field scaled(Field field, double scale) {
    field.scale *= scale;
    field.root = field.graph.multiply(field.graph.constant(scale), field.root);
    derive_programs(field);
    return field;
}

Field with_elements_of(Field field, const Program& beside) {
    const ArrayPacking read = packing_of(field.packing.size(), std::array{&beside});
    for (std::size_t a = 0; a < read.size(); ++a) {
        std::vector<int>& packed = field.packing[a];
        std::ranges::copy_if(read[a], std::back_inserter(packed), [&](int one) {
            return std::ranges::find(packed, one) == packed.end();
        });
    }
    return field;
}

Field with_walls(Field field, double distance) {
    field.wall_distance = distance;
    derive_programs(field);
    return field;
}

GlslSignature value_signature() { return {"float field(vec3 p)", "float", {"p.x", "p.y", "p.z"}}; }

GlslSignature directional_signature() {
    return {"vec2 field_directional(vec3 p, vec3 d)",
            "vec2",
            {"p.x", "p.y", "p.z", "d.x", "d.y", "d.z"}};
}

GlslSignature gradient_signature() {
    return {"vec3 field_gradient(vec3 p)", "vec3", {"p.x", "p.y", "p.z"}};
}

std::string glsl_value(const Field& field) {
    return emit_glsl(field.value, value_signature(), field.packing);
}

std::string glsl_directional(const Field& field) {
    return emit_glsl(field.directional, directional_signature(), field.packing);
}

std::string glsl_gradient(const Field& field) {
    return emit_glsl(field.gradient, gradient_signature(), field.packing);
}

} // namespace isomotion::formula
