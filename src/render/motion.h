// The channel velocity: the speed of the surface where a pixel sees it.
//
// A surface F(p, t) = 0 only has a velocity along its normal, -(dF/dt) / |grad F|. dF/dt is the
// difference of F over a short time around the frame's, at the same place in the world. So it
// includes everything that moves: parameters, elements of arrays, the placement.
#pragma once

#include <array>
#include <span>

#include "image/frame.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::render {

struct Motion {
    scene::SceneAt before, after;
    double seconds = 0; // from `before` to `after`
};

// The motion of one surface. It refers to its scene's states, which must outlive it.
struct SurfaceMotion {
    SurfaceMotion(const scene::SceneAt& its_scene, const Motion& motion, std::size_t index)
        : now(its_scene, index)
        , before(motion.before, index)
        , after(motion.after, index)
        , seconds(motion.seconds) {}

    scene::OneSurfaceAt now, before, after;
    double seconds;
};

// A tenth of a frame around the frame's time; one-sided at the beginning and the end of an
// animation that doesn't loop. Throws as scene::at does.
Motion motion_about(const scene::Scene& scene, int frame);

// Converts formula coordinates of `from` to those of `to` through world coordinates; three rows.
std::array<glm::vec4, 3> change_of_place(const scene::PlacementAt& from,
                                         const scene::PlacementAt& to);

// Formula coordinates of a place on a pixel's ray; columns and rows count from the lower left.
glm::dvec3 place_on_ray(const scene::Rays& rays, const glm::ivec2& pixel, int width, int height,
                        double t);

// Velocity of one hit: along the normal in world units per second, towards F > 0; and of the
// surface point in the picture, in pixels per second to the right and down, including the camera's
// own motion. `position` is the hit in formula coordinates; `before` and `after` hold the gradient
// and the value of F there.
glm::dvec3 velocity(const SurfaceMotion& motion, int width, int height, const glm::dvec3& position,
                    const glm::dvec4& before, const glm::dvec4& after);

} // namespace isomotion::render
