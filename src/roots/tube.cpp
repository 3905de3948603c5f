#include "roots/tube.h"

#include <algorithm>
#include <cmath>

namespace isomotion::roots {
namespace {

glm::dvec3 as_float(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

struct RayPart {
    double near = 1, far = 0;
    bool empty() const { return !(near <= far); }
};

// The part of a line inside the bounds, which are grown by `margin` on all sides (shrunk if it is
// negative).
RayPart clip(const scene::BoundsAt& bounds, const glm::dvec3& anchor, const glm::dvec3& direction,
             double margin) {
    if (bounds.shape == scene::Bounds::Shape::sphere) {
        const double radius = bounds.radius + margin;
        const glm::dvec3 from = anchor - bounds.centre;
        const double middle = -glm::dot(from, direction);
        const glm::dvec3 foot = from + middle * direction;
        const double square = radius * radius - glm::dot(foot, foot);
        if (radius < 0 || square < 0) return {};
        return {middle - std::sqrt(square), middle + std::sqrt(square)};
    }
    RayPart span{-HUGE_VAL, HUGE_VAL};
    for (int k = 0; k < 3; ++k) {
        const double low = bounds.min[k] - margin - anchor[k];
        const double high = bounds.max[k] + margin - anchor[k];
        if (low > high) return {}; // thinner than the margin
        if (std::abs(direction[k]) < 1e-12) {
            if (low > 0 || high < 0) return {};
            continue;
        }
        const double a = low / direction[k], b = high / direction[k];
        span.near = std::max(span.near, std::min(a, b));
        span.far = std::min(span.far, std::max(a, b));
    }
    return span;
}

} // namespace

Tubes::Tubes(const scene::OneSurfaceAt& now, int width, int height, const scene::Aim& aim)
    : rays_(scene::rays(now, width, height, aim))
    , bounds_(now.surface.bounds)
    , width_(width)
    , height_(height) {
    for (glm::dvec3* v : {&rays_.origin, &rays_.axis, &rays_.right, &rays_.up}) *v = as_float(*v);
    for (glm::dvec3* v : {&bounds_.min, &bounds_.max, &bounds_.centre}) *v = as_float(*v);
    bounds_.radius = double(float(bounds_.radius));
    rounding_ = scene::ray_rounding(rays_, bounds_, scene::Norm::coordinate);
}

Tube Tubes::at(int column, int row) const {
    const double u = (2 * column + 1.0) / width_ - 1, v = 1 - (2 * row + 1.0) / height_;
    const glm::dvec3 across = u * rays_.right + v * rays_.up;
    const glm::dvec3 from_eye = rays_.parallel ? rays_.axis : rays_.axis + across;
    const double to_eye = glm::length(from_eye);
    Tube tube;
    tube.holds = rounding_.holds;
    tube.anchor = rays_.origin + across;
    tube.direction = from_eye / to_eye;
    tube.footprint = 2 * glm::length(rays_.up) / height_;

    tube.direction_radius = rounding_.direction;
    const double reach = bounds_.radius + glm::length(tube.anchor - bounds_.centre);
    tube.radius = rounding_.at_distance(reach);

    // The ends of the interval are as uncertain as the ray, and rounded themselves.
    const double margin = 4 * tube.radius;
    const RayPart outer = clip(bounds_, tube.anchor, tube.direction, margin);
    const RayPart inner = clip(bounds_, tube.anchor, tube.direction, -margin);
    if (outer.empty()) return tube;
    tube.near = std::max(outer.near, -to_eye - margin);
    tube.far = outer.far;
    if (!(tube.near <= tube.far)) return tube; // behind the eye
    tube.near_inside = inner.empty() ? tube.far : std::max(inner.near, -to_eye + margin);
    tube.far_inside = inner.empty() ? tube.near : inner.far;
    return tube;
}

} // namespace isomotion::roots
