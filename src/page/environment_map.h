// What is around a scene, small enough for a page.
#pragma once

#include <cstddef>
#include <functional>
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

// Wider maps become the means of their texels. `warn`, unless it is empty, is told of texels that
// were mended. Throws as image::read_environment() does.
EnvironmentMap environment_map(const scene::Environment& environment,
                               const std::function<void(const std::string&)>& warn);

} // namespace isomotion::page
