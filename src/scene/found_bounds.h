// Bounds for a scene that gives none: a ball about the surface, found by intervals.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace isomotion::scene {

struct FoundBounds {
    // The surface is looked for from -reach to reach along each axis.
    static constexpr double reach = 10;
    // The radius where a surface goes on beyond that, or where nothing is found.
    static constexpr double otherwise = 3;

    glm::dvec3 centre{0};
    double radius = otherwise;
    bool is_about_surface = false; // at all frames; else it goes on beyond, or there may be none
};

// Bounds of a scene whose own don't count. None if looking would take long: many elements or
// frames.
std::optional<FoundBounds> find_bounds(const Scene& scene);

} // namespace isomotion::scene
