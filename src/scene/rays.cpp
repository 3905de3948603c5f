#include "scene/rays.h"

#include <algorithm>
#include <cmath>

namespace isomotion::scene {

Rays rays(const OneSurfaceAt& one, int width, int height) {
    const PlacementAt& place = one.surface.placement;
    const glm::dmat3 to_local = glm::transpose(place.rotate);
    const glm::dvec3 eye = place.to_local(one.scene.camera.position);
    const glm::dvec3 forward =
        glm::normalize(to_local * (one.scene.camera.target - one.scene.camera.position));
    glm::dvec3 up = to_local * one.scene.camera.up;
    // A camera looking along its own `up` (straight down, say) still has an upright picture.
    if (glm::length(glm::cross(forward, up)) < 1e-9 * glm::length(up)) {
        up = std::abs(forward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    }
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    up = glm::cross(right, forward);

    // Bounds beside or behind the eye: any plane before the eye will do.
    const double depth = std::max(glm::dot(one.surface.bounds.centre - eye, forward),
                                  0.5 * one.surface.bounds.radius);
    Rays rays;
    rays.parallel = one.scene.camera.projection == Camera::Projection::orthographic;
    const double shown = rays.parallel ? 0.5 * one.scene.camera.height / place.scale
                                       : depth * std::tan(glm::radians(one.scene.camera.fov) / 2);
    const double half_height = shown / one.scene.camera.zoom;
    rays.axis = depth * forward;
    rays.origin = eye + rays.axis;
    rays.up = half_height * up;
    rays.right = half_height * double(width) / height * right;
    return rays;
}

Rays rays(const OneSurfaceAt& one, int width, int height, const Aim& aim) {
    Rays moved = rays(one, width, height);
    const Rays still = moved;
    // Adding zeros would change the signs of others.
    if (aim.pixel != glm::dvec2(0)) {
        const glm::dvec3 across =
            2 * aim.pixel.x / width * still.right + 2 * aim.pixel.y / height * still.up;
        moved.origin += across;
        if (!still.parallel) moved.axis += across;
    }
    if (aim.lens != glm::dvec2(0)) {
        const double scale = one.surface.placement.scale;
        const glm::dvec3 place =
            0.5 * one.scene.camera.aperture / scale *
            (aim.lens.x * glm::normalize(still.right) + aim.lens.y * glm::normalize(still.up));
        // What was straight ahead now lies beside the lens' point. How far beside falls from all of
        // it at the eye to nothing in focus.
        const double beyond = glm::length(still.axis) * scale / one.scene.camera.focus;
        moved.origin += (1 - beyond) * place;
        moved.axis -= beyond * place;
    }
    return moved;
}

} // namespace isomotion::scene
