#include "scene/surfaces.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/shared_by_surfaces.h"

namespace isomotion::scene {

namespace {

bool mirrors_all(const Scene& surface) {
    return surface.material.reflection == Material::Reflection::self;
}

// All surfaces of a scene, in the file's order.
std::vector<const Scene*> all_of(const Scene& scene) {
    std::vector<const Scene*> all{&scene};
    for (const Scene& other : scene.others) all.push_back(&other);
    return all;
}

Among among_all(const Scene& scene, Among one) {
    const std::vector<const Scene*> all = all_of(scene);
    one.mirrors = 0;
    one.matters.clear();
    one.depth = 0;
    for (int k = 0; k < int(all.size()); ++k) {
        const Material& material = all[std::size_t(k)]->material;
        one.mirrors |= int(mirrors_all(*all[std::size_t(k)])) << k;
        if (!material.glass) continue;
        one.matters.push_back(k);
        one.depth = std::max(one.depth, material.glass->depth);
    }
    std::ranges::stable_sort(one.matters, std::greater{},
                             [&](int k) { return all[std::size_t(k)]->material.glass->priority; });
    return one;
}

} // namespace

Scene of_surface(const Scene& scene, int index) {
    Scene one = index == 0 ? scene : scene.others[std::size_t(index - 1)];
    one.others.clear();
    if (scene.among.count > 1) one.among = among_all(scene, one.among);
    if (index == 0) return one;
    share_surroundings(scene, one);
    one.output = scene.output;
    return one;
}

Scene alone(const Scene& scene, int index) {
    // Its own tracks tell where camera and lights are.
    Scene one = index == 0 ? scene : scene.others[std::size_t(index - 1)];
    one.others.clear();
    one.among = {};
    if (!one.surface.label.empty()) one.title += fmt::format(" ({})", one.surface.label);
    return one;
}

std::vector<std::string> surface_names(const Scene& scene) {
    std::vector<std::string> names{scene.surface.label};
    for (const Scene& other : scene.others) names.push_back(other.surface.label);
    return names;
}

int surface_named(const Scene& scene, const std::string& name, const std::string& option) {
    if (scene.others.empty())
        throw SceneError(fmt::format("{}: has one surface; leave {} out", scene.title, option));
    const std::vector<std::string> names = surface_names(scene);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return int(found - names.begin());
    throw SceneError(fmt::format("{} {}: the scene has no such surface; it has {}", option, name,
                                 fmt::join(names, ", ")));
}

std::string place_of(const Scene& surface, const std::string& name) {
    StatedAt at = stated_at(surface.value_places.get(), surface.file.string(), name);
    const std::string& label = surface.surface.label;
    if (label.empty()) return fmt::format("{}: {}", at.position, at.key);
    constexpr std::string_view of_one = "surface.";
    if (at.key.starts_with(of_one)) at.key.erase(0, of_one.size());
    return fmt::format("{}: surfaces.{}.{}", at.position, label, at.key);
}

void expect_one_surface(const Scene& scene, const std::string& who) {
    if (scene.others.empty()) return;
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
