#include "render/proof_rays.h"

#include <algorithm>

#include "scene/ray_rounding.h"
#include "shader/proof_text.h"

namespace isomotion::render {
namespace {

// By how many times the rounding of points and directions (scene/ray_rounding.h) a proof's boxes
// are wider than its own ray.
struct Roundings {
    double points, directions;
};
// The proof's ray in floats and the marched one are each within once the rounding of the exact one;
// the ends of boxes and of directions are rounded, too.
constexpr Roundings of_two_rays{2.2, 3};
// A ray in doubles is the exact one but for 2^-40 of the rounding; the rest is for its boxes.
constexpr Roundings of_one_ray{1.04, 1.01};

} // namespace

ProofRays proof_rays(const scene::OneSurface& one, const scene::OneSurfaceAt& now, int width,
                     int height, const scene::Aim& aim) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const double footprint = 2 * glm::length(rays.up) / height;
    ProofRays found;
    found.beam = beam_range(now, width, height, aim, shader::proved_block);
    found.coarse_beam = beam_range(now, width, height, aim, shader::coarse_proved_block);
    // The ends of a ray's part are off by what its beam's pieces are.
    const double margin = found.beam.w, rounding = margin / beam_roundings;
    const scene::RayRounding of_rays =
        scene::ray_rounding(rays, now.surface.bounds, scene::Norm::length);
    found.in_range = of_rays.holds;
    const double direction = of_rays.direction;
    const auto shortest = float(std::max(margin, footprint / 256));
    const auto thickness = [&](const Roundings& times) {
        return RayThickness{
            glm::vec4(times.points * rounding, times.directions * direction, margin, footprint / 8),
            shortest};
    };
    found.of_floats = thickness(of_two_rays);
    found.of_doubles = thickness(of_one_ray);

    found.frame = frame_block(one, now, width, height, aim);
    const auto more = float(margin);
    if (now.surface.bounds.shape == scene::Bounds::Shape::sphere) {
        found.frame.bounds_min.w += more;
    } else {
        found.frame.bounds_min -= more;
        found.frame.bounds_max += more;
    }
    return found;
}

} // namespace isomotion::render
