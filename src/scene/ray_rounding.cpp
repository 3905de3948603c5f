#include "scene/ray_rounding.h"

#include <algorithm>
#include <cmath>

namespace isomotion::scene {
namespace {

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// See the end of the model.
constexpr double shortest = 0x1p-50, longest = 0x1p62;

bool in_range(const Rays& rays, const BoundsAt& bounds) {
    const double from_eye = glm::length(rays.axis);
    const double across = std::max(largest(rays.right), largest(rays.up));
    const double reach = std::max({largest(rays.origin), largest(bounds.centre),
                                   glm::length(rays.right) + glm::length(rays.up)});
    return std::min({bounds.radius, from_eye, across}) >= shortest &&
           std::max({bounds.radius, from_eye, reach}) <= longest;
}

} // namespace

RayRounding ray_rounding(const Rays& rays, const BoundsAt& bounds, Norm norm) {
    constexpr double unit = RayRounding::unit;
    const auto size = [norm](const glm::dvec3& v) {
        return norm == Norm::length ? glm::length(v) : largest(v);
    };
    const double spread = size(rays.right) + size(rays.up);
    // The lens' rim may shear the axis out of the perpendicular.
    const double depth = glm::dot(rays.axis, glm::normalize(glm::cross(rays.up, rays.right)));
    const double across = rays.parallel ? 0 : spread / depth;
    return {.anchor = 16 * unit * (largest(rays.origin) + spread),
            .direction = 16 * unit * (1 + across),
            .centre = 2 * unit * largest(bounds.centre),
            .slant = glm::length(rays.axis) / depth + across,
            .holds = in_range(rays, bounds)};
}

} // namespace isomotion::scene
