// The environment of a scene, small enough for a page.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::page {

// Linear R, G and B as halves, row by row from the top.
struct EnvironmentMap {
    int width = 0, height = 0;
    std::vector<std::byte> texels;
};

inline constexpr int widest_map = 512;

struct Environment {
    EnvironmentMap map;
    std::optional<EnvironmentMap> levels; // for rough mirrors: image::environment_levels()
};

// The environment of a scene, if it has one. Wider maps are reduced to means of their texels.
// `warn`, unless empty, is called for repaired texels. Throws as image::read_environment() does.
std::optional<Environment> environment(const scene::Scene& scene,
                                       const std::function<void(const std::string&)>& warn);

} // namespace isomotion::page
