// The set of all rays that single precision may compute for one pixel.
//
// The shader computes a ray and the points on it in float32 from the uniforms of
// render/uniform_blocks.h. A tube is the ray in double from the same float32 values, thickened by
// the largest error of float32 arithmetic (scene/ray_rounding.h). So a statement that holds for all
// of a tube holds for the ray that was drawn. Formula coordinates.
#pragma once

#include <glm/glm.hpp>

#include "scene/ray_rounding.h"
#include "scene/rays.h"
#include "scene/scene_at.h"

namespace isomotion::roots {

struct Tube {
    glm::dvec3 anchor{0}, direction{0}; // points are anchor + t * direction
    double radius = 0;                  // of the tube, in each coordinate
    double direction_radius = 0;        // uncertainty of the direction, in each coordinate
    // The part inside the bounds and in front of the eye: certainly inside from near_inside to
    // far_inside, certainly outside before near and beyond far. Empty if near > far.
    double near = 1, near_inside = 1, far_inside = 0, far = 0;
    double footprint = 0; // width of the pixel at the anchor
    bool holds = true; // whether it contains the shader's ray; false if squares over- or underflow
};

// The tubes of a picture.
class Tubes {
public:
    Tubes(const scene::OneSurfaceAt& now, int width, int height, const scene::Aim& aim = {});

    int width() const { return width_; }
    int height() const { return height_; }
    // Rows from the top.
    Tube at(int column, int row) const;

private:
    scene::Rays rays_; // rounded to float32
    scene::BoundsAt bounds_;
    scene::RayRounding rounding_;
    int width_, height_;
};

} // namespace isomotion::roots
