#include "scene/reading/lights.h"

#include <fmt/format.h>

#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

Light read_light(Section section, TrackTable& tracks) {
    Light light;
    read_keys(keys::light_keys, section, light, tracks);
    if (section.has("direction") == section.has("position")) {
        section.tell(
            "needs one of direction = [x, y, z], pointing to the light, and position = [x, y, z]");
        pass_over(keys::light_place_keys, section);
        light.direction = tracks.add(section.full_name("direction"), 0, 0, 1);
        light.falloff = light.radius = std::nullopt; // whose rules depend on the kind of light
    } else {
        read_keys(keys::light_place_keys, section, light, tracks);
    }
    light.is_point = section.has("position");
    if (light.falloff && !light.is_point) {
        section.tell("falloff", "is of a light with a position; this one has none");
    }
    if (light.with_camera && light.is_point) {
        section.tell("with_camera",
                     "is of a light with a direction: to the viewer's right, up and back");
    }
    section.refuse_rest();
    return light;
}

// What is around the surfaces and has its keys in one table.
template<class Around, class Table>
std::optional<Around> read_section(Section& document, const char* name, const Table& table,
                                   TrackTable& tracks) {
    auto section = document.section(name);
    if (!section) return std::nullopt;
    Around around;
    read_keys(table, *section, around, tracks);
    section->refuse_rest();
    return around;
}

// Whether a section that is there has no such key.
bool lacks(Section& document, const char* name, const char* key) {
    const auto section = document.section(name);
    return section && !section->has(key);
}

} // namespace

void read_lights(Section& document, Scene& scene, TrackTable& tracks) {
    const std::vector<Section> list = document.list("lights", "light", limits::lights);
    for (const Section& section : list) scene.lights.push_back(read_light(section, tracks));
    if (!scene.lights.empty()) return;
    Light light;
    light.headlight = true;
    light.direction = tracks.add("lights[0].direction", 0, 0, 1);
    light.color = tracks.add("lights[0].color", 1, 1, 1);
    scene.lights.push_back(light);
}

void read_surroundings(Section& document, Scene& scene, TrackTable& tracks) {
    scene.ground = read_section<Ground>(document, "ground", keys::ground_keys, tracks);
    scene.fog = read_section<Fog>(document, "fog", keys::fog_keys, tracks);
    if (scene.fog && lacks(document, "fog", "color")) {
        const auto& background = scene.output.background;
        scene.fog->color = tracks.add("fog.color", background[0], background[1], background[2]);
    }
    scene.ambient = read_section<Ambient>(document, "ambient", keys::ambient_keys, tracks);
    if (scene.ambient && lacks(document, "ambient", "bottom"))
        scene.ambient->bottom = scene.ambient->top;
    scene.occlusion = read_section<Occlusion>(document, "occlusion", keys::occlusion_keys, tracks);
}

} // namespace isomotion::scene
