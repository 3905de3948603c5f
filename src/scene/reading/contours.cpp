#include "scene/reading/contours.h"

#include "formula/contours.h"
#include "formula/graph/parser.h"
#include "scene/key_tables.h"
#include "scene/reading/paint.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {

ContourParts read_contours(Section section, TrackTable& tracks) {
    ContourParts parts;
    parts.value_key = section.dotted("value");
    parts.value_node = section.find("value");
    if (parts.value_node) {
        parts.value = section.text("value");
    } else {
        section.tell_missing("value", "an expression of x, y, z, t and the surface's parameters");
    }
    read_keys(keys::contour_keys, section, parts.contours, tracks);
    section.refuse_rest();
    return parts;
}

Contours make_contours(const ContourParts& parts, const SurfaceParts& surface) {
    Contours contours = parts.contours;
    const auto& value = parts.value;
    if (!value) return contours;
    try {
        contours.value = std::make_shared<formula::Paint>(
            formula::make_contours(*value, surface.vocabulary, *surface.surface.field));
    } catch (const formula::ParseError& error) {
        fail(*parts.value_node, parts.value_key, error.what());
    } catch (const std::length_error& error) {
        fail(*parts.value_node, parts.value_key, error.what());
    }
    check_work(*contours.value, surface, *parts.value_node, parts.value_key);
    return contours;
}

} // namespace isomotion::scene
