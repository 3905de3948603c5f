#include "scene/reading/contours.h"

#include "formula/contours.h"
#include "formula/graph/parser.h"
#include "scene/reading/paint.h"

namespace isomotion::scene {

ContourParts read_contours(Section section, TrackTable& tracks) {
    ContourParts parts;
    parts.value_key = section.dotted("value");
    parts.value_node = section.find("value");
    if (!parts.value_node) {
        fail(section.table(), parts.value_key,
             "is missing; give an expression of x, y, z, t and the surface's parameters");
    }
    parts.value = *section.text("value");
    const auto number = [&](const char* name, double preset) {
        const toml::node* node = section.find(name);
        return tracks.add(section.dotted(name),
                          node ? *section.track(name) : animation::TrackSource(preset), node);
    };
    if (!section.has("every")) {
        fail(section.table(), section.dotted("every"),
             "is missing; give how far apart in value the lines are, as 0.1");
    }
    parts.contours.every = number("every", 1);
    parts.contours.from = number("from", 0);
    parts.contours.width = number("width", 1);
    const toml::node* color = section.find("color");
    parts.contours.color =
        color ? tracks.add(section.dotted("color"), *section.vector("color"), color)
              : tracks.add(section.dotted("color"), 0, 0, 0);
    section.refuse_rest();
    return parts;
}

Contours make_contours(const ContourParts& parts, const SurfaceParts& surface) {
    Contours contours = parts.contours;
    try {
        contours.value = std::make_shared<formula::Paint>(
            formula::make_contours(parts.value, surface.vocabulary, *surface.surface.field));
    } catch (const formula::ParseError& error) {
        fail(*parts.value_node, parts.value_key, error.what());
    } catch (const std::length_error& error) {
        fail(*parts.value_node, parts.value_key, error.what());
    }
    check_work(*contours.value, surface, *parts.value_node, parts.value_key);
    return contours;
}

} // namespace isomotion::scene
