#include "scene/surfaces.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "scene/error.h"

namespace isomotion::scene {

namespace {

// Calls visit() with each track of the settings that all surfaces of a scene share.
template<class Visit> void for_each_shared_track(Scene& scene, const Visit& visit) {
    const auto single = [&](TrackId& track) { visit(track); };
    const auto all = [&](Vec3Track& tracks) { std::ranges::for_each(tracks, visit); };
    const auto given = [&](auto& setting) {
        using Setting = std::remove_cvref_t<decltype(*setting)>;
        if (!setting) return;
        if constexpr (std::is_same_v<Setting, TrackId>) single(*setting);
        if constexpr (std::is_same_v<Setting, Vec3Track>) all(*setting);
    };
    Camera& camera = scene.camera;
    for (auto* setting : {&camera.position, &camera.target}) given(*setting);
    for (auto* setting : {&camera.distance, &camera.height, &camera.aperture, &camera.focus})
        given(*setting);
    for (auto* track : {&camera.azimuth, &camera.elevation, &camera.fov, &camera.zoom})
        single(*track);
    all(camera.up);
    for (Light& light : scene.lights) {
        all(light.direction);
        all(light.color);
        given(light.falloff);
        given(light.radius);
    }
    for (Cut& cut : scene.sections) {
        if (cut.is_ball) {
            all(cut.centre);
            single(cut.radius);
        } else {
            all(cut.normal);
            all(cut.point);
            single(cut.offset);
        }
    }
    if (scene.ground) {
        single(scene.ground->height);
        all(scene.ground->color);
    }
    if (scene.fog) {
        single(scene.fog->density);
        single(scene.fog->start);
        all(scene.fog->color);
    }
    if (scene.ambient) {
        all(scene.ambient->top);
        all(scene.ambient->bottom);
    }
    if (scene.occlusion) {
        given(scene.occlusion->reach);
        single(scene.occlusion->strength);
    }
    if (scene.environment) {
        single(scene.environment->rotation);
        single(scene.environment->intensity);
    }
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
        return scene.surfaces[k].material.glass->priority;
    });
    return found;
}

int depth_of_matters(const Scene& scene) {
    int depth = 0;
    for (const std::size_t k : matters(scene))
        depth = std::max(depth, scene.surfaces[k].material.glass->depth);
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
    const Surface& surface = one.surface;
    StatedAt at = stated_at(surface.value_places.get(), one.scene.file.string(), name);
    const std::string& label = surface.label;
    if (label.empty()) return fmt::format("{}: {}", at.position, at.key);
    constexpr std::string_view of_one = "surface.";
    if (at.key.starts_with(of_one)) at.key.erase(0, of_one.size());
    return fmt::format("{}: surfaces.{}.{}", at.position, label, at.key);
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
