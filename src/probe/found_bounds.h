// Finds bounds for a scene that gives none: a ball around the surface, found by intervals.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace isomotion::probe {

struct FoundBounds {
    // The search for the surface covers -reach to reach along each axis, and goes on to reaches
    // that are `wider` times as large each, up to `farthest`, until one holds the surface of a
    // frame.
    static constexpr double reach = 10, wider = 8, farthest = 3e6;
    // The radius if the surface goes on beyond them all, if none is found, and if the work ends.
    static constexpr double otherwise = 3;

    glm::dvec3 centre{0};
    double radius = otherwise;
    // At all frames, up to the farthest reach; false if it goes on beyond the ball, if a part of it
    // may lie elsewhere, or if there may be none.
    bool is_about_surface = false;
};

// Bounds of a surface; its own bounds are ignored. None if the search would take long, because of
// many elements or frames.
std::optional<FoundBounds> find_bounds(const scene::OneSurface& one);

// Whether bounds of some surface of the scene were looked for, since no file gives them.
bool are_bounds_found(const scene::Scene& scene);

} // namespace isomotion::probe
