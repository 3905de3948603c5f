// Bounds for a scene that gives none: a ball about the surface, found by intervals.
#pragma once

#include <span>

#include <glm/glm.hpp>

#include "formula/smoothness.h"

namespace isomotion::scene {

struct FoundBounds {
    // The surface is looked for from -reach to reach along each axis.
    static constexpr double reach = 10;
    // Of a surface that goes on beyond that, or of which nothing is found.
    static constexpr double otherwise = 3;

    glm::dvec3 centre{0};
    double radius = otherwise;
    bool is_about_surface = false; // else it goes on beyond, or there may be none
};

// About the surface in all regions, whose boxes don't count. What their bindings leave out, the
// ways of elements between frames, may lead out of it.
FoundBounds find_bounds(const formula::Field& field, std::span<const formula::Region> regions);

} // namespace isomotion::scene
