#include "scene/reading/space.h"

namespace isomotion::scene {

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
    if (box) {
        bounds.shape = Bounds::Shape::box;
        const toml::array* corners = box->as_array();
        if (!corners || corners->size() != 2) {
            fail(*box, "surface.bounds.box", "must be two corners: [[x0, y0, z0], [x1, y1, z1]]");
        }
        const std::string key = "surface.bounds.box";
        bounds.min =
            tracks.add(key + ".min", read_vector(*corners->get(0), key + "[0]"), corners->get(0));
        bounds.max =
            tracks.add(key + ".max", read_vector(*corners->get(1), key + "[1]"), corners->get(1));
    } else {
        bounds.radius = tracks.add("surface.bounds.sphere", *given->track("sphere"), sphere);
        const toml::node* centre = given->find("centre");
        bounds.centre = centre
                            ? tracks.add("surface.bounds.centre", *given->vector("centre"), centre)
                            : tracks.add("surface.bounds.centre", 0, 0, 0);
    }
    given->refuse_rest();

    Placement& placement = parts.surface.placement;
    auto place = section->section("transform");
    const auto dotted = [&](const std::string& name) {
        return section->dotted("transform") + '.' + name;
    };
    const auto vector = [&](const std::string& name) {
        const std::string key = dotted(name);
        const toml::node* node = place ? place->find(name) : nullptr;
        return node ? tracks.add(key, *place->vector(name), node) : tracks.add(key, 0, 0, 0);
    };
    placement.translate = vector("translate");
    placement.rotate = vector("rotate");
    const toml::node* scale = place ? place->find("scale") : nullptr;
    placement.scale = tracks.add(
        dotted("scale"), scale ? *place->track("scale") : animation::TrackSource(1.0), scale);
    if (place) place->refuse_rest();
}

} // namespace isomotion::scene
