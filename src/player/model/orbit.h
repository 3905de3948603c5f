// Moves cameras by the mouse: from a camera and a drag to a new camera.
//
// `drag` and `at` are in heights of the picture, to the right and up; `at` counts from the
// picture's centre. So nothing depends on pixels, and a drag has the same effect in every window.
// All lengths are relative, so scenes of any size move alike. The camera's `up`, fov, zoom and lens
// never change; a plane in focus at the target stays there.
//
// A reset needs no function: it uses the scene's own camera at the frame.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene_at.h"

namespace isomotion::player {

inline constexpr double degrees_per_height = 180; // of an orbit
// Degrees by which an orbit stays away from the poles, where the picture's upright direction is
// undefined.
inline constexpr double pole_distance = 0.1;

// Right, up and forward of the picture: unit vectors in world coordinates. For a camera that looks
// along its own `up` they are those of its rays (scene/rays.h).
struct PictureAxes {
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
};
PictureAxes picture_axes(const scene::CameraAt& camera);

// The picture's height at the target, in world units.
double shown_height(const scene::CameraAt& camera);

// The point seen at `at` on the plane through the target, parallel to the picture.
glm::dvec3 point_at(const scene::CameraAt& camera, const glm::dvec2& at);

// Rotates around the target as if the drag turned the surface: a drag to the right moves the camera
// left. Stops at the poles; keeps the distance.
scene::CameraAt orbited(const scene::CameraAt& camera, const glm::dvec2& drag);

// Moves camera and target in the picture's plane: points at the target's distance stay under the
// cursor.
scene::CameraAt panned(const scene::CameraAt& camera, const glm::dvec2& drag);

// Moves nearer by the factor exp(-amount), farther if it is negative; an orthographic camera scales
// its height instead. The point of the target's plane under `at` stays in place. The camera doesn't
// move if lengths would exceed the range of numbers.
scene::CameraAt dollied(const scene::CameraAt& camera, double amount, const glm::dvec2& at = {});

// Keeps the direction and moves to a distance at which a sphere around the bounds touches the
// nearer edges of a picture with this width / height. Targets the centre of the bounds.
scene::CameraAt fitted(const scene::CameraAt& camera, const scene::BoundsAt& bounds,
                       const scene::PlacementAt& placement, double aspect);

} // namespace isomotion::player
