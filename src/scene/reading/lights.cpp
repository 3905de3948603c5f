#include "scene/reading/lights.h"

#include <fmt/format.h>

#include "scene/limits.h"

namespace isomotion::scene {
namespace {

Light read_light(const toml::node& at, const std::string& key, TrackTable& tracks) {
    Light light;
    Section section(*at.as_table(), key);
    const toml::node* color = section.find("color");
    light.color = color ? tracks.add(key + ".color", *section.vector("color"), color)
                        : tracks.add(key + ".color", 1, 1, 1);
    const toml::node* direction = section.find("direction");
    const toml::node* position = section.find("position");
    if (bool(direction) == bool(position)) {
        fail(at, key,
             "needs one of direction = [x, y, z], pointing to the light, and position = [x, y, z]");
    }
    light.is_point = position != nullptr;
    const std::string place = light.is_point ? "position" : "direction";
    light.direction =
        tracks.add(key + "." + place, *section.vector(place), position ? position : direction);
    if (const toml::node* falloff = section.find("falloff")) {
        if (!light.is_point) {
            fail(*falloff, key + ".falloff", "is of a light with a position; this one has none");
        }
        light.falloff = tracks.add(key + ".falloff", *section.track("falloff"), falloff);
    }
    light.shadow = section.boolean("shadow").value_or(false);
    if (const toml::node* radius = section.find("radius"))
        light.radius = tracks.add(key + ".radius", *section.track("radius"), radius);
    light.with_camera = section.boolean("with_camera").value_or(false);
    if (light.with_camera && light.is_point) {
        fail(*section.find("with_camera"), key + ".with_camera",
             "is of a light with a direction: to the viewer's right, up and back");
    }
    section.refuse_rest();
    return light;
}

} // namespace

void read_lights(Section& document, Scene& scene, TrackTable& tracks) {
    constexpr std::size_t most = limits::lights;
    const toml::node* node = document.find("lights");
    const toml::array* list = node ? node->as_array() : nullptr;
    if (node && (!list || list->empty() || !list->is_array_of_tables())) {
        fail(*node, "lights", "must be written as [[lights]], one such table a light");
    }
    if (!list) {
        Light light;
        light.headlight = true;
        light.direction = tracks.add("lights[0].direction", 0, 0, 1);
        light.color = tracks.add("lights[0].color", 1, 1, 1);
        scene.lights.push_back(light);
        return;
    }
    if (list->size() > most) fail(*node, "lights", fmt::format("at most {}", most));
    for (std::size_t k = 0; k < list->size(); ++k) {
        scene.lights.push_back(read_light(*list->get(k), fmt::format("lights[{}]", k), tracks));
    }
}

void read_surroundings(Section& document, Scene& scene, TrackTable& tracks) {
    // An animated value or vector of a table, or its default.
    const auto number = [&](Section& section, const std::string& name, double preset) {
        const toml::node* at = section.find(name);
        return tracks.add(section.dotted(name),
                          at ? *section.track(name) : animation::TrackSource(preset), at);
    };
    const auto color = [&](Section& section, const std::string& name,
                           const std::array<double, 3>& preset) {
        const toml::node* at = section.find(name);
        const std::string key = section.dotted(name);
        return at ? tracks.add(key, *section.vector(name), at)
                  : tracks.add(key, preset[0], preset[1], preset[2]);
    };
    if (auto section = document.section("ground")) {
        Ground ground;
        if (!section->has("height")) {
            fail(section->table(), "ground", "needs height = the ground's z in world coordinates");
        }
        ground.height = number(*section, "height", 0);
        ground.color = color(*section, "color", {0.5, 0.5, 0.5});
        scene.ground = ground;
        section->refuse_rest();
    }
    if (auto section = document.section("fog")) {
        Fog fog;
        if (!section->has("density")) {
            fail(section->table(), "fog", "needs density = what a world unit takes away, as 0.1");
        }
        fog.density = number(*section, "density", 0);
        fog.start = number(*section, "start", 0);
        fog.color = color(*section, "color", scene.output.background);
        scene.fog = fog;
        section->refuse_rest();
    }
    if (auto section = document.section("ambient")) {
        if (!section->has("top")) {
            fail(section->table(), "ambient",
                 "needs top = [r, g, b], the light from above; from below comes the same, or "
                 "bottom");
        }
        Ambient ambient;
        ambient.top = color(*section, "top", {});
        const bool has_bottom = section->find("bottom") != nullptr;
        ambient.bottom = has_bottom ? color(*section, "bottom", {}) : ambient.top;
        scene.ambient = ambient;
        section->refuse_rest();
    }
    if (auto section = document.section("occlusion")) {
        Occlusion occlusion;
        if (section->find("radius")) occlusion.reach = number(*section, "radius", 0);
        occlusion.strength = number(*section, "strength", 1);
        scene.occlusion = occlusion;
        section->refuse_rest();
    }
}

} // namespace isomotion::scene
