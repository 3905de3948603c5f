#include "formula/paint.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "formula/element_weights.h"
#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"
#include "formula/graph/recentred.h"
#include "formula/graph/substitute.h"
#include "formula/hessian.h"

namespace isomotion::formula {
namespace {

NodeId as_it_is(Graph&, const Node&, NodeId rebuilt) { return rebuilt; }

// The field's value, for what is written about it.
Paint begin_paint(const Field& field) {
    Paint paint;
    paint.field = substitute(paint.graph, field.graph, std::array{field.root}, as_it_is).front();
    return paint;
}

// A graph of its own: however large the field is, there is room for as much as a formula may hold.
NodeId parse_beside(std::string_view text, const Names& names, const Field& field, Graph& to) {
    Graph written;
    const NodeId root = recentred(written, parse(text, names, written), field.origin);
    return substitute(to, written, std::array{root}, as_it_is).front();
}

Paint finish(Paint paint, const Field& field) {
    Graph working = paint.graph;
    paint.value = schedule(working, lower(working, paint.roots));
    if (paint.uses("mean_curvature") || paint.uses("gaussian_curvature")) {
        paint.hessian = hessian(field);
    }
    return paint;
}

std::string glsl_value(const Paint& paint, GlslSignature signature, const ArrayPacking& packing) {
    signature.inputs = {"p.x",   "p.y",         "p.z",         "n.x",         "n.y",
                        "n.z",   "curvature.x", "curvature.y", "evaluations", "paint_time",
                        "own.r", "own.g",       "own.b"};
    return "uniform float paint_time;\n" + emit_glsl(paint.value, signature, packing);
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

Paint make_paint(std::string_view text, const Vocabulary& surface, const Field& field) {
    Vocabulary vocabulary = surface;
    vocabulary.inputs = paint_names;
    Paint paint = begin_paint(field);
    paint.text = text;
    paint.roots = {parse_beside(text, Names(vocabulary), field, paint.graph)};
    return finish(std::move(paint), field);
}

Paint make_color(const ColorTexts& texts, const Vocabulary& surface, const Field& field) {
    Vocabulary vocabulary = surface;
    vocabulary.inputs = paint_names;
    const Names names(vocabulary);
    Paint paint = begin_paint(field);
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const NodeId own = paint.graph.input(int(paint_names.size() + k));
        const auto& text = texts[k];
        paint.roots.push_back(text ? parse_beside(*text, names, field, paint.graph) : own);
        paint.text += (k > 0 ? ", " : "") + text.value_or("as it is");
    }
    return finish(std::move(paint), field);
}

std::optional<Paint> make_mean_color(const Vocabulary& surface, const Field& field, int array,
                                     const std::array<int, 3>& fields, double unit) {
    Paint paint = begin_paint(field);
    Graph& g = paint.graph;
    const std::optional<NodeId> term = element_weight(g, paint.field, array);
    const std::optional<NodeId> key = least_key(g, paint.field, array);
    if (!term && !key) return std::nullopt;
    const ArrayName& names = surface.arrays[std::size_t(array)];
    const auto mean_of = [&](NodeId value, NodeId own) {
        const NodeId factor = g.constant(unit);
        if (!term) return g.multiply(factor, g.pick(array, *key, value));
        const NodeId weight = g.unary(Op::abs, *term), all = g.sum(array, weight);
        const NodeId sum = g.sum(array, g.multiply(weight, value));
        return g.select(g.constant(0), all, g.multiply(factor, g.divide(sum, all)), own);
    };
    paint.text = term ? "the elements' mean of" : "of the least element";
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const int part = fields[k];
        const FieldName& name = names.fields[std::size_t(part)];
        const NodeId value = name.parameter ? g.parameter(*name.parameter) : g.element(array, part);
        paint.roots.push_back(mean_of(value, g.input(int(paint_names.size() + k))));
        paint.text += fmt::format(" {}.{}", names.name, name.name);
    }
    return finish(std::move(paint), field);
}

std::string glsl_paint_value(const Paint& paint, const ArrayPacking& packing) {
    return glsl_value(
        paint,
        {"float paint_value(vec3 p, vec3 n, vec2 curvature, float evaluations)", "float", {}},
        packing);
}

std::string glsl_color_value(const Paint& paint, const ArrayPacking& packing) {
    return glsl_value(
        paint,
        {"vec3 color_value(vec3 p, vec3 n, vec2 curvature, float evaluations, vec3 own)",
         "vec3",
         {}},
        packing);
}

} // namespace isomotion::formula
