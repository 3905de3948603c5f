#include "scene/surfaces.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/nth_surface.h"
#include "scene/shared_by_surfaces.h"

namespace isomotion::scene {

namespace {

bool mirrors_all(const Scene& surface) {
    return surface.surface.material.reflection == Material::Reflection::self;
}

Among among_all(const Scene& scene, Among one) {
    one.mirrors = 0;
    one.matters.clear();
    one.depth = 0;
    for (int k = 0; k < int(surface_count(scene)); ++k) {
        const Scene& surface = nth_surface(scene, std::size_t(k));
        const Material& material = surface.surface.material;
        one.mirrors |= int(mirrors_all(surface)) << k;
        if (!material.glass) continue;
        one.matters.push_back(k);
        one.depth = std::max(one.depth, material.glass->depth);
    }
    std::ranges::stable_sort(one.matters, std::greater{}, [&](int k) {
        return nth_surface(scene, std::size_t(k)).surface.material.glass->priority;
    });
    return one;
}

} // namespace

Scene of_surface(const Scene& scene, int index) {
    Scene one = nth_surface(scene, std::size_t(index));
    one.others.clear();
    if (scene.among.count > 1) one.among = among_all(scene, one.among);
    if (index == 0) return one;
    share_surroundings(scene, one);
    one.output = scene.output;
    return one;
}

Scene alone(const Scene& scene, int index) {
    // Its own tracks tell where camera and lights are.
    Scene one = nth_surface(scene, std::size_t(index));
    one.others.clear();
    one.among = {};
    if (!one.surface.label.empty()) one.title += fmt::format(" ({})", one.surface.label);
    return one;
}

std::vector<std::string> surface_names(const Scene& scene) {
    std::vector<std::string> names;
    for_each_surface(scene, [&](const Scene& one) { names.push_back(one.surface.label); });
    return names;
}

int surface_named(const Scene& scene, const std::string& name, const std::string& option) {
    if (!has_several_surfaces(scene))
        throw SceneError(fmt::format("{}: has one surface; leave {} out", scene.title, option));
    const std::vector<std::string> names = surface_names(scene);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return int(found - names.begin());
    throw SceneError(fmt::format("{} {}: the scene has no such surface; it has {}", option, name,
                                 fmt::join(names, ", ")));
}

std::string place_of(const Scene& surface, const std::string& name) {
    StatedAt at = stated_at(surface.surface.value_places.get(), surface.file.string(), name);
    const std::string& label = surface.surface.label;
    if (label.empty()) return fmt::format("{}: {}", at.position, at.key);
    constexpr std::string_view of_one = "surface.";
    if (at.key.starts_with(of_one)) at.key.erase(0, of_one.size());
    return fmt::format("{}: surfaces.{}.{}", at.position, label, at.key);
}

void expect_one_surface(const Scene& scene, const std::string& who) {
    if (!has_several_surfaces(scene)) return;
    throw SceneError(fmt::format("{}: has {} surfaces ({}), and {} knows one", scene.title,
                                 scene.among.count, fmt::join(surface_names(scene), ", "), who));
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
