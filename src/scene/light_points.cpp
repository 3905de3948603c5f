#include "scene/light_points.h"

#include <algorithm>
#include <cmath>

namespace isomotion::scene {
namespace {

// A vector of unit length across `v`, which is as long.
glm::dvec3 across(const glm::dvec3& v) {
    const glm::dvec3 other = std::abs(v.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    return glm::normalize(glm::cross(other, v));
}

} // namespace

bool is_lit_by_discs(const SceneAt& now) {
    return std::ranges::any_of(now.lights, [](const LightAt& light) { return light.radius > 0; });
}

SceneAt lit_from(SceneAt now, const glm::dvec2& disc) {
    if (disc == glm::dvec2(0)) return now;
    const SurfaceAt& first = now.surfaces.front();
    const glm::dvec3 middle = first.placement.to_world(first.bounds.centre);
    for (LightAt& light : now.lights) {
        if (light.radius == 0) continue;
        const glm::dvec3 way = light.is_point ? light.direction - middle : light.direction;
        const double length = glm::length(way);
        if (length == 0) continue; // in the middle of the bounds it faces nothing
        const glm::dvec3 a = across(way / length), b = glm::cross(way / length, a);
        light.direction += light.radius * (disc.x * a + disc.y * b);
        if (!light.is_point) light.direction = glm::normalize(light.direction);
    }
    return now;
}

} // namespace isomotion::scene
