#include "scene/surfaces.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/key_tables.h"

namespace isomotion::scene {

namespace {

// Calls visit() with each track of the settings that all surfaces of a scene share.
template<class Visit> void for_each_shared_track(Scene& scene, const Visit& visit) {
    keys::for_each_track(keys::camera_keys, scene.camera, visit);
    for (Light& light : scene.lights) {
        std::ranges::for_each(light.direction, visit);
        keys::for_each_track(keys::light_keys, light, visit);
    }
    for (Cut& cut : scene.sections) {
        if (cut.is_ball) {
            keys::for_each_track(keys::cut_ball_keys, cut, visit);
        } else {
            keys::for_each_track(keys::plane_keys, cut, visit);
        }
    }
    if (scene.ground) keys::for_each_track(keys::ground_keys, *scene.ground, visit);
    if (scene.fog) keys::for_each_track(keys::fog_keys, *scene.fog, visit);
    if (scene.ambient) keys::for_each_track(keys::ambient_keys, *scene.ambient, visit);
    if (scene.occlusion) keys::for_each_track(keys::occlusion_keys, *scene.occlusion, visit);
    if (scene.environment) keys::for_each_track(keys::environment_keys, *scene.environment, visit);
}

} // namespace

Scene alone(const OneSurface& one) {
    Scene scene = one.scene;
    scene.surfaces = {one.surface};
    const std::string& label = one.surface.label;
    if (!label.empty()) scene.title += fmt::format(" ({})", label);
    if (one.index == 0) return scene; // whose tracks they are
    // Each surface's animation has tracks of these names: it was read with them.
    const auto& named = one.scene.surfaces.front().animation.tracks();
    const animation::Animation& own = one.surface.animation;
    for_each_shared_track(
        scene, [&](TrackId& track) { track = own.find(named[std::size_t(track)].name).value(); });
    return scene;
}

int mirrors(const Scene& scene) {
    int mask = 0;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const Material& material = scene.surfaces[k].material;
        mask |= int(material.reflection == Material::Reflection::self) << k;
    }
    return mask;
}

std::vector<std::size_t> matters(const Scene& scene) {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        if (scene.surfaces[k].material.glass) found.push_back(k);
    }
    std::ranges::stable_sort(found, std::greater{}, [&](std::size_t k) {
        const auto& glass = scene.surfaces[k].material.glass;
        return glass ? glass->priority : 0;
    });
    return found;
}

int depth_of_matters(const Scene& scene) {
    int depth = 0;
    for (const Surface& surface : scene.surfaces) {
        if (const auto& glass = surface.material.glass) depth = std::max(depth, glass->depth);
    }
    return depth;
}

std::vector<std::string> surface_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Surface& surface : scene.surfaces) names.push_back(surface.label);
    return names;
}

std::size_t surface_named(const Scene& scene, const std::string& name, const std::string& option) {
    if (scene.surfaces.size() == 1)
        throw SceneError(fmt::format("{}: has one surface; leave {} out", scene.title, option));
    const std::vector<std::string> names = surface_names(scene);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return std::size_t(found - names.begin());
    throw SceneError(fmt::format("{} {}: the scene has no such surface; it has {}", option, name,
                                 fmt::join(names, ", ")));
}

std::string place_of(const OneSurface& one, const std::string& name) {
    const StatedAt at = stated_at(one.surface.value_places.get(), one.scene.file.string(), name);
    return fmt::format("{}: {}", at.position, at.key);
}

Isolation changed_alike(Isolation other, const Isolation& before, const Isolation& now) {
    for (auto number : {&Isolation::step, &Isolation::near, &Isolation::far, &Isolation::horizon}) {
        if (now.*number != before.*number && before.*number != 0)
            other.*number *= now.*number / before.*number;
    }
    if (now.bisections != before.bisections) other.bisections = now.bisections;
    if (now.safety != before.safety) other.safety = now.safety;
    if (now.limit != before.limit) other.limit = now.limit;
    return other;
}

} // namespace isomotion::scene
