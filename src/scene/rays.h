// The rays of a picture, in formula coordinates. Doubles on the CPU become floats on the GPU.
//
// Every ray is given by its `anchor`, not by the eye. The anchor is where the ray crosses the plane
// through the middle of the bounds, parallel to the picture. Float keeps 24 bits of a coordinate,
// so a point computed from an eye 10^5 away would jitter by 10^-2. Anchors have the size of the
// bounds, whatever the camera's distance and the surface's placement.
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

Rays rays(const OneSurfaceAt& one, int width, int height);

// The choice of a pixel's ray: through its centre and from the eye, unless moved.
struct Aim {
    glm::dvec2 pixel{0}; // from the pixel's centre, in pixels: right, up
    glm::dvec2 lens{0};  // from the lens' centre, in radii of the aperture: right, up
};

// The rays of this aim. The default aim gives exactly the rays above. From another point of the
// lens, rays lead to the same points of the plane in focus: space is sheared about that plane. The
// lens of an orthographic camera is telecentric: a pixel's rays are a cone with its tip in the
// plane in focus, as wide at the eye's plane as the aperture.
Rays rays(const OneSurfaceAt& one, int width, int height, const Aim& aim);

} // namespace isomotion::scene
