#include "formula/paint.h"

#include <algorithm>

#include <fmt/format.h>

#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"
#include "formula/hessian.h"

namespace isomotion::formula {
namespace {

// The elements of arrays that the field's programs don't read have no place in the packing.
void refuse_unpacked(const Paint& paint, const Vocabulary& vocabulary, const Field& field) {
    for (NodeId id = 0; id < paint.graph.size(); ++id) {
        const Node& node = paint.graph[id];
        if (node.op != Op::element) continue;
        const auto& packed = field.packing[std::size_t(node.index)];
        if (std::find(packed.begin(), packed.end(), node.second) != packed.end()) continue;
        const ArrayName& array = vocabulary.arrays[std::size_t(node.index)];
        const std::string& name = array.fields[std::size_t(node.second)].name;
        throw ParseError(paint.text, paint.text.find(name),
                         fmt::format("the surface's formula leaves out the field '{}' of '{}'; "
                                     "only fields that it reads are there to paint with",
                                     name, array.name));
    }
}

} // namespace

bool Paint::uses(std::string_view name) const {
    const auto at = std::find(paint_names.begin(), paint_names.end(), name);
    const int index = int(at - paint_names.begin());
    return std::any_of(value.instructions.begin(), value.instructions.end(), [&](const auto& now) {
        return now.kind == Instruction::Kind::operation && now.op == Op::input &&
               now.index == index;
    });
}

Paint make_paint(std::string_view text, Vocabulary surface, const Field& field) {
    Paint paint;
    paint.text = text;
    surface.inputs = paint_names;
    const NodeId root = parse(text, surface, paint.graph);
    refuse_unpacked(paint, surface, field);
    Graph working = paint.graph;
    paint.value = schedule_lowered(working, root);
    if (paint.uses("mean_curvature") || paint.uses("gaussian_curvature")) {
        paint.hessian = hessian(field);
    }
    return paint;
}

std::string glsl_paint_value(const Paint& paint, const ArrayPacking& packing) {
    return "uniform float paint_time;\n" +
           emit_glsl(paint.value,
                     {"float paint_value(vec3 p, vec3 n, vec2 curvature, float evaluations)",
                      "float",
                      {"p.x", "p.y", "p.z", "n.x", "n.y", "n.z", "curvature.x", "curvature.y",
                       "evaluations", "paint_time"}},
                     packing);
}

} // namespace isomotion::formula
