// What is around a scene, small enough for a page.
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
    std::optional<EnvironmentMap> levels; // what rough mirrors show: image::environment_levels()
};

// What is around a scene that has an environment. Wider maps become the means of their texels.
// `warn`, unless it is empty, is told of texels that were mended. Throws as
// image::read_environment() does.
Environment environment(const scene::Scene& scene,
                        const std::function<void(const std::string&)>& warn);

} // namespace isomotion::page
