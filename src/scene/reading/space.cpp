#include "scene/reading/space.h"

#include <fmt/format.h>

#include "probe/found_bounds.h"
#include "scene/key_tables.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

void read_box(Section& section, Bounds& bounds, TrackTable& tracks) {
    bounds.shape = Bounds::Shape::box;
    const std::string name = section.full_name("box"), key = section.dotted("box");
    std::array<std::optional<VectorSource>, 2> corners;
    const toml::array* given = section.find("box")->as_array();
    section.attempt("box", [&] {
        if (!given || given->size() != 2)
            fail(*section.find("box"), key, "must be two corners: [[x0, y0, z0], [x1, y1, z1]]");
        for (std::size_t k = 0; k < 2; ++k)
            corners[k] = read_vector(*given->get(k), fmt::format("{}[{}]", key, k));
    });
    const auto corner = [&](std::size_t k, const char* end, double otherwise) {
        const toml::node* node = section.is_wrong("box") ? nullptr : given->get(k);
        return tracks.add(name + end, corners[k], {otherwise, otherwise, otherwise}, node,
                          key + end);
    };
    bounds.min = corner(0, ".min", -1);
    bounds.max = corner(1, ".max", 1);
}

void add_ball(double radius, Bounds& bounds, TrackTable& tracks) {
    bounds.radius = tracks.add("surface.bounds.sphere", std::nullopt, radius, nullptr);
    bounds.centre = tracks.add("surface.bounds.centre", 0, 0, 0);
}

// The section with the bounds, of the catalogue where the scene gives none.
std::optional<Section> given_bounds(Section& surface, SurfaceParts& parts) {
    auto given = surface.section("bounds");
    if (!surface.has("bounds") && parts.catalogue)
        given = Section(*parts.catalogue, "", surface.mistakes()).section("bounds");
    if (!given) return std::nullopt;
    // Their tracks have one name.
    return Section(std::vector<Section::Layer>{{&given->table(), parts.bounds_key}},
                   "surface.bounds", surface.mistakes());
}

void read_bounds(Section& surface, SurfaceParts& parts, TrackTable& tracks) {
    Bounds& bounds = parts.surface.bounds;
    std::optional<Section> given = given_bounds(surface, parts);
    if (!given) {
        add_ball(probe::FoundBounds::reach, bounds, tracks);
        parts.lacks_bounds = !surface.has("bounds") && !parts.catalogue;
        if (surface.has("bounds") || !parts.catalogue) return;
        surface.tell_missing("bounds",
                             "{ sphere = radius } or { box = [[x0, y0, z0], [x1, y1, z1]] }");
        return;
    }
    if (given->has("box") == given->has("sphere")) {
        given->tell("needs one of sphere = radius and box = [[..], [..]]");
        add_ball(1, bounds, tracks);
        pass_over(keys::ball_keys, *given);
        pass_over(keys::box_keys, *given);
    } else if (given->has("box")) {
        read_box(*given, bounds, tracks);
        refuse_keys(keys::ball_keys, *given, "is of a ball; these bounds are a box");
    } else {
        read_keys(keys::ball_keys, *given, bounds, tracks);
        pass_over(keys::box_keys, *given);
    }
    given->refuse_rest();
}

} // namespace

void read_space(Section& surface, SurfaceParts& parts, TrackTable& tracks) {
    read_bounds(surface, parts, tracks);
    const toml::table none;
    auto place = surface.section("transform");
    Section transform =
        place ? *place
              : Section(std::vector<Section::Layer>{{&none, surface.dotted("transform")}},
                        "surface.transform", surface.mistakes());
    read_keys(keys::transform_keys, transform, parts.surface.placement, tracks);
    transform.refuse_rest();
}

} // namespace isomotion::scene
