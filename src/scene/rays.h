// The rays of a picture, in formula coordinates, from double on the CPU to float on the GPU.
//
// Every ray is given by the point `anchor` where it crosses the plane through the middle of the
// bounds, parallel to the picture, and not by the eye: float keeps 24 bits of a coordinate, so a
// point computed from an eye 10^5 away would jitter by 10^-2. Anchors have the size of the bounds,
// whatever the camera's distance and the surface's placement.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene_at.h"

namespace isomotion::scene {

// Pixel centre (column + 0.5, row + 0.5), rows counted from the bottom, has the picture coordinates
// (u, v) = 2 * (column + 0.5, row + 0.5) / (width, height) - 1. Its ray:
//   anchor    = origin + u * right + v * up
//   direction = normalize(axis + u * right + v * up), or of parallel rays normalize(axis)
// and begins at anchor - direction * |that vector|: at the eye, or on the plane through it.
struct Rays {
    glm::dvec3 origin{0}; // where the axis meets the plane
    glm::dvec3 axis{0};   // from the eye to `origin`
    glm::dvec3 right{0}, up{0};
    bool parallel = false; // of an orthographic camera
};

Rays rays(const SceneAt& scene, int width, int height);

// Which of a pixel's rays: through its centre and from the eye, unless moved.
struct Aim {
    glm::dvec2 pixel{0}; // from the pixel's centre, in pixels: right, up
    glm::dvec2 lens{0};  // from the lens' middle, in radii of the aperture: right, up
};

// The rays of this aim; without one they are those above, bit for bit. From another point of the
// lens they lead to the same points of the plane in focus: space is sheared about that plane. The
// lens of an orthographic camera is telecentric: a pixel's rays are a cone with its tip in the
// plane in focus, as wide at the eye's plane as the aperture.
Rays rays(const SceneAt& scene, int width, int height, const Aim& aim);

} // namespace isomotion::scene
