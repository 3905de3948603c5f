#include "scene/reading/color.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "formula/graph/parser.h"
#include "formula/graph/substitute.h"
#include "scene/reading/paint.h"

namespace isomotion::scene {
namespace {

using formula::ParseError;

std::optional<ParseError> mistake_in(const std::string& text,
                                     const formula::Vocabulary& vocabulary) {
    try {
        formula::Graph graph;
        formula::parse(text, vocabulary, graph);
    } catch (const ParseError& error) {
        return error;
    }
    return std::nullopt;
}

// Whether a part names the place, or an array's elements. If it is wrong as either, the reading
// that went on farther in the text tells the mistake.
bool is_of_place(const std::string& text, const toml::node& node, const std::string& key,
                 const SurfaceParts& parts) {
    formula::Vocabulary of_time;
    of_time.inputs = {"t"};
    of_time.parameters = parts.parameters;
    of_time.allows_random = true;
    const auto as_value = mistake_in(text, of_time);
    if (!as_value) return false;
    if (!parts.are_arrays_known) return true; // which it may name
    formula::Vocabulary of_place = parts.vocabulary;
    of_place.inputs = formula::paint_names;
    const auto as_paint = mistake_in(text, of_place);
    if (!as_paint) return true;
    const auto place = [](const ParseError& error) {
        return std::pair(error.line(), error.column());
    };
    fail(node, key, place(*as_paint) < place(*as_value) ? as_value->what() : as_paint->what());
}

struct ColorFields {
    std::array<const char*, 3> names;
    double unit;
};

constexpr ColorFields color_fields[] = {{{"r", "g", "b"}, 1},
                                        {{"red", "green", "blue"}, 1.0 / 255}};

// Whether the formula, or another field, reads a field: it is no colour then.
bool is_read(const SurfaceParts& parts, std::size_t array, std::size_t field) {
    if (parts.surface.animation.is_referenced(array, field)) return true;
    const formula::Graph& graph = parts.surface.field->graph;
    const auto& parameter = parts.vocabulary.arrays[array].fields[field].parameter;
    const auto below = formula::nodes_below(graph, std::array{parts.surface.field->root});
    return std::ranges::any_of(below, [&](formula::NodeId id) {
        const formula::Node& node = graph[id];
        if (node.op == formula::Op::parameter) return parameter == node.index;
        return node.op == formula::Op::element && std::size_t(node.index) == array &&
               std::size_t(node.second) == field;
    });
}

// The three fields of an array, if it has them and they are free.
std::optional<std::array<int, 3>> free_fields(const SurfaceParts& parts, std::size_t array,
                                              const std::array<const char*, 3>& names) {
    const auto& fields = parts.vocabulary.arrays[array].fields;
    std::array<int, 3> found{};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto at = std::ranges::find(fields, names[k], &formula::FieldName::name);
        if (at == fields.end()) return std::nullopt;
        found[k] = int(at - fields.begin());
        if (is_read(parts, array, std::size_t(found[k]))) return std::nullopt;
    }
    return found;
}

} // namespace

ColorParts read_color(const toml::node& node, const std::string& key, const SurfaceParts& parts,
                      TrackTable& tracks) {
    ColorParts color;
    auto sources = read_vector(node, key);
    const toml::array* list = node.as_array();
    for (std::size_t k = 0; list && k < sources.size(); ++k) {
        const auto* expression = std::get_if<animation::Expression>(&sources[k]);
        const std::string name = fmt::format("{}.{}", key, "xyz"[k]);
        if (!expression || !is_of_place(expression->text, node, name, parts)) continue;
        color.of_place[k] = expression->text;
        sources[k] = 0.0;
    }
    color.tracks = tracks.add("material.color", sources, stand_in_vector, &node, key);
    color.node = &node;
    color.key = key;
    return color;
}

std::shared_ptr<const formula::Paint> make_color(const ColorParts& color,
                                                 const SurfaceParts& parts) {
    const formula::Field& field = *parts.surface.field;
    if (color.is_of_place()) {
        try {
            const auto paint = std::make_shared<formula::Paint>(
                formula::make_color(color.of_place, parts.vocabulary, field));
            check_work(*paint, parts, *color.node, color.key);
            return paint;
        } catch (const std::length_error& error) {
            fail(*color.node, color.key, error.what());
        }
    }
    for (std::size_t a = 0; a < parts.arrays.size() && !color.is_given; ++a) {
        for (const ColorFields& known : color_fields) {
            const auto fields = free_fields(parts, a, known.names);
            if (!fields) continue;
            auto mean =
                formula::make_mean_color(parts.vocabulary, field, int(a), *fields, known.unit);
            if (mean) return std::make_shared<formula::Paint>(*std::move(mean));
        }
    }
    return nullptr;
}

} // namespace isomotion::scene
