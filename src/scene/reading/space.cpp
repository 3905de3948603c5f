#include "scene/reading/space.h"

#include "scene/key_tables.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

void read_box(const toml::node& box, Bounds& bounds, TrackTable& tracks) {
    bounds.shape = Bounds::Shape::box;
    const std::string key = "surface.bounds.box";
    const toml::array* corners = box.as_array();
    if (!corners || corners->size() != 2)
        fail(box, key, "must be two corners: [[x0, y0, z0], [x1, y1, z1]]");
    const auto corner = [&](std::size_t k, const char* name) {
        const toml::node& node = *corners->get(k);
        return tracks.add(key + name, read_vector(node, fmt::format("{}[{}]", key, k)), &node);
    };
    bounds.min = corner(0, ".min");
    bounds.max = corner(1, ".max");
}

} // namespace

void read_space(Section& document, SurfaceParts& parts, TrackTable& tracks) {
    auto section = document.section("surface");
    Bounds& bounds = parts.surface.bounds;
    std::optional<Section> given = section->section("bounds");
    if (!given && parts.catalogue) given = Section(*parts.catalogue, "").section("bounds");
    if (!given) {
        fail(section->table(), "surface.bounds",
             "is missing; give { sphere = radius } or { box = [[x0, y0, z0], [x1, y1, z1]] }");
    }
    const toml::node* box = given->find("box");
    const toml::node* sphere = given->find("sphere");
    if (bool(box) == bool(sphere)) {
        fail(given->table(), "surface.bounds",
             "needs one of sphere = radius and box = [[..], [..]]");
    }
    Section named(given->table(), "surface.bounds"); // also those of the catalogue
    if (box) {
        read_box(*box, bounds, tracks);
    } else {
        read_keys(keys::ball_keys, named, bounds, tracks);
        given->find("centre");
    }
    given->refuse_rest();

    const toml::table none;
    auto place = section->section("transform");
    Section transform = place ? *place : Section(none, section->dotted("transform"));
    read_keys(keys::transform_keys, transform, parts.surface.placement, tracks);
    transform.refuse_rest();
}

} // namespace isomotion::scene
