#include "scene/surfaces.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/shared_by_surfaces.h"

namespace isomotion::scene {

namespace {

bool mirrors_all(const Scene& surface) {
    return surface.material.reflection == Material::Reflection::self;
}

} // namespace

Scene of_surface(const Scene& scene, int index) {
    Scene one = index == 0 ? scene : scene.others[std::size_t(index - 1)];
    one.others.clear();
    if (scene.among.count > 1) {
        one.among.mirrors = int(mirrors_all(scene));
        for (std::size_t k = 0; k < scene.others.size(); ++k)
            one.among.mirrors |= int(mirrors_all(scene.others[k])) << (k + 1);
    }
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

void expect_one_surface(const Scene& scene, const std::string& who) {
    if (scene.others.empty()) return;
    throw SceneError(fmt::format("{}: has {} surfaces ({}), and {} knows one", scene.title,
                                 scene.among.count, fmt::join(surface_names(scene), ", "), who));
}

} // namespace isomotion::scene
