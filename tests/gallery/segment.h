// The part of a pixel's ray in the bounds, in double.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/rays.h"
#include "scene/scene_at.h"

namespace isomotion::render {

// Formula coordinates: anchor + t * direction for t from near to far; none if near > far.
struct Segment {
    glm::dvec3 anchor, direction;
    double near = 1, far = 0;
};

// The segment of a pixel in a square picture with `side` pixels a row; rows count from the top.
inline Segment segment(const scene::SceneAt& now, const scene::Rays& rays, int side, int column,
                       int row) {
    const double u = 2 * (column + 0.5) / side - 1, v = 1 - 2 * (row + 0.5) / side;
    const glm::dvec3 across = u * rays.right + v * rays.up;
    const glm::dvec3 from_eye = rays.parallel ? rays.axis : rays.axis + across;
    Segment s{rays.origin + across, glm::normalize(from_eye)};
    if (now.surfaces[0].bounds.shape == scene::Bounds::Shape::sphere) {
        const glm::dvec3 from = s.anchor - now.surfaces[0].bounds.centre;
        const double middle = -glm::dot(from, s.direction);
        const double square = now.surfaces[0].bounds.radius * now.surfaces[0].bounds.radius -
                              glm::dot(from, from) + middle * middle;
        if (square < 0) return s;
        s.near = middle - std::sqrt(square);
        s.far = middle + std::sqrt(square);
    } else {
        const glm::dvec3 a = (now.surfaces[0].bounds.min - s.anchor) / s.direction;
        const glm::dvec3 b = (now.surfaces[0].bounds.max - s.anchor) / s.direction;
        const glm::dvec3 enter = glm::min(a, b), leave = glm::max(a, b);
        s.near = std::max({enter.x, enter.y, enter.z});
        s.far = std::min({leave.x, leave.y, leave.z});
    }
    s.near = std::max(s.near, -glm::length(from_eye));
    return s;
}

} // namespace isomotion::render
