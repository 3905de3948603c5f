// Moves cameras by the mouse: from a camera and a drag to a camera.
//
// `drag` and `at` are in heights of the picture, to the right and up; `at` counts from the
// picture's middle. So nothing depends on pixels, and a drag means the same in every window. All
// lengths are ratios: scenes of any size move alike. The camera's `up` never changes, nor do fov,
// zoom and lens; a plane in focus at the target stays there.
//
// Resetting needs nothing: it is the scene's own camera at the frame.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene_at.h"

namespace isomotion::player {

inline constexpr double degrees_per_height = 180; // of an orbit
// Degrees that an orbit keeps off the poles, where the picture's upright direction is lost.
inline constexpr double pole_distance = 0.1;

// Right, up and forward of the picture: unit length, world. A camera that looks along its own `up`
// has the upright direction that its rays have (scene/rays.h).
struct PictureAxes {
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
};
PictureAxes picture_axes(const scene::CameraAt& camera);

// The picture's height at the target, in world units.
double shown_height(const scene::CameraAt& camera);

// The point of the plane through the target, parallel to the picture, that is seen at `at`.
glm::dvec3 point_at(const scene::CameraAt& camera, const glm::dvec2& at);

// Turns about the target as if the drag turned the surface: a drag to the right moves the camera
// left. Stops at the poles; keeps the distance.
scene::CameraAt orbited(const scene::CameraAt& camera, const glm::dvec2& drag);

// Moves camera and target in the picture's plane: what is as far away as the target stays under
// the cursor.
scene::CameraAt panned(const scene::CameraAt& camera, const glm::dvec2& drag);

// Nearer by the factor exp(-amount), farther if negative; an orthographic camera takes in so much
// less. The point of the target's plane under `at` stays where it is seen. Where lengths would
// leave the range of numbers the camera stays.
scene::CameraAt dollied(const scene::CameraAt& camera, double amount, const glm::dvec2& at = {});

// Keeps the direction and moves so far that a sphere about the bounds touches the nearer edges of a
// picture with this width / height. Targets the middle of the bounds.
scene::CameraAt fitted(const scene::CameraAt& camera, const scene::BoundsAt& bounds,
                       const scene::PlacementAt& placement, double aspect);

} // namespace isomotion::player
