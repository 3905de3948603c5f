#include "scene/reading/paint.h"

#include <fmt/format.h>

#include "formula/graph/parser.h"
#include "probe/shown_range.h"
#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

void read_range(Section& section, PaintParts& parts, TrackTable& tracks) {
    const std::string key = section.dotted("range");
    const toml::node* range = section.find("range");
    if (range && range->value_exact<std::string>() == "auto") {
        parts.shown_node = range;
        parts.range_key = key;
        parts.paint.shown = Range{0, 1}; // until all else is known
        return;
    }
    constexpr const char* right = "[low, high], the values at the ends of the map, or \"auto\"";
    std::optional<animation::TrackSource> low, high;
    if (!range) {
        section.tell_missing("range", right);
    } else {
        section.attempt("range", [&] {
            const toml::array* ends = range->as_array();
            if (!ends || ends->size() != 2) fail(*range, key, fmt::format("must be {}", right));
            low = read_track(*ends->get(0), key + ".low");
            high = read_track(*ends->get(1), key + ".high");
        });
    }
    const std::string name = section.full_name("range");
    parts.paint.low = tracks.add(name + ".low", low, 0, range, key + ".low");
    parts.paint.high = tracks.add(name + ".high", high, 1, range, key + ".high");
}

} // namespace

PaintParts read_paint(Section section, TrackTable& tracks) {
    PaintParts parts;
    parts.value_node = section.find("value");
    if (parts.value_node) {
        parts.value = section.text("value");
    } else {
        section.tell_missing("value",
                             fmt::format("an expression of {} and the surface's parameters",
                                         fmt::join(formula::paint_names, ", ")));
    }
    parts.value_key = section.dotted("value");
    read_range(section, parts, tracks);
    read_keys(keys::colormap_keys, section, parts.paint, tracks);
    section.refuse_rest();
    return parts;
}

void check_work(const formula::Paint& paint, const SurfaceParts& surface, const toml::node& node,
                const std::string& key) {
    std::vector<int> counts;
    for (const animation::Array& array : surface.arrays) counts.push_back(array.count);
    double operations = formula::cost(paint.value, counts).operations;
    if (paint.hessian)
        operations = std::max(operations, formula::cost(*paint.hessian, counts).operations);
    if (operations <= limits::operations_at_a_point) return;
    fail(node, key,
         fmt::format("takes {:.3g} operations at one point, all elements of its sums counted; at "
                     "most {:.3g} are possible: give its arrays fewer elements",
                     operations, limits::operations_at_a_point));
}

Paint make_paint(const PaintParts& parts, const SurfaceParts& surface) {
    Paint paint = parts.paint;
    const auto& value = parts.value;
    if (!value) return paint;
    try {
        paint.value = std::make_shared<formula::Paint>(
            formula::make_paint(*value, surface.vocabulary, *surface.surface.field));
    } catch (const formula::ParseError& error) {
        fail(*parts.value_node, parts.value_key, error.what());
    } catch (const std::length_error& error) {
        fail(*parts.value_node, parts.value_key, error.what());
    }
    check_work(*paint.value, surface, *parts.value_node, parts.value_key);
    if (parts.shown_node && paint.value->uses("evaluations")) {
        fail(*parts.value_node, parts.value_key,
             "how many evaluations there are is known once a picture is drawn; give the range as "
             "[low, high]");
    }
    return paint;
}

void find_shown_range(const PaintParts& parts, const OneSurface& one, Paint& paint) {
    if (!parts.shown_node) return;
    try {
        const probe::ShownRange shown = probe::shown_range(one, *paint.value);
        paint.shown = shown.range;
        paint.met = shown.met;
    } catch (const probe::NoRange& error) {
        fail(*parts.shown_node, parts.range_key, error.what());
    }
}

} // namespace isomotion::scene
