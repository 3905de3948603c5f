#include "render/motion.h"

#include <algorithm>

namespace isomotion::render {
namespace {

// Where a picture shows a point of the world: pixels to the right and down.
glm::dvec2 pixel_of(const scene::OneSurfaceAt& now, int width, int height,
                    const glm::dvec3& world) {
    const scene::Rays rays = scene::rays(now, width, height);
    const glm::dvec3 from = now.surface.placement.to_local(world) - (rays.origin - rays.axis);
    const double depth =
        rays.parallel ? 1 : glm::dot(from, rays.axis) / glm::dot(rays.axis, rays.axis);
    const glm::dvec3 across = from / depth - rays.axis;
    const double u = glm::dot(across, rays.right) / glm::dot(rays.right, rays.right);
    const double v = glm::dot(across, rays.up) / glm::dot(rays.up, rays.up);
    return {(u + 1) / 2 * width, (1 - v) / 2 * height};
}

} // namespace

Motion motion_about(const scene::Scene& scene, int frame) {
    const animation::Timeline& timeline = scene.timeline;
    const double apart = 0.1 * double(timeline.fps.denominator) / double(timeline.fps.numerator);
    double before = timeline.time(frame) - apart / 2, after = timeline.time(frame) + apart / 2;
    if (!timeline.loops) {
        // Data that moves elements ends where the animation does.
        before = std::max(before, timeline.time(1));
        if (timeline.frames > 1) after = std::min(after, timeline.time(timeline.frames));
    }
    return {scene::at(scene, before), scene::at(scene, after), after - before};
}

std::array<glm::vec4, 3> change_of_place(const scene::PlacementAt& from,
                                         const scene::PlacementAt& to) {
    const glm::dvec3 origin = to.to_local(from.to_world({0, 0, 0}));
    glm::dmat3 axes;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 unit(0);
        unit[k] = 1;
        axes[k] = from.scale / to.scale * (glm::transpose(to.rotate) * (from.rotate * unit));
    }
    std::array<glm::vec4, 3> rows;
    for (int k = 0; k < 3; ++k) {
        rows[std::size_t(k)] = glm::dvec4(axes[0][k], axes[1][k], axes[2][k], origin[k]);
    }
    return rows;
}

glm::dvec3 place_on_ray(const scene::Rays& rays, const glm::ivec2& pixel, int width, int height,
                        double t) {
    const double u = 2 * (pixel.x + 0.5) / width - 1, v = 2 * (pixel.y + 0.5) / height - 1;
    const glm::dvec3 across = u * rays.right + v * rays.up;
    return rays.origin + across +
           t * glm::normalize(rays.parallel ? rays.axis : rays.axis + across);
}

glm::dvec3 velocity(const SurfaceMotion& motion, int width, int height, const glm::dvec3& position,
                    const glm::dvec4& before, const glm::dvec4& after) {
    const glm::dvec3 gradient = 0.5 * (glm::dvec3(before) + glm::dvec3(after));
    const double slope = glm::length(gradient);
    if (!(slope > 0) || !(motion.seconds > 0)) return {0, 0, 0};
    const scene::PlacementAt& place = motion.now.surface.placement;
    const double speed = -(after.w - before.w) / motion.seconds / slope * place.scale;
    const glm::dvec3 way = 0.5 * motion.seconds * speed / slope * (place.rotate * gradient);
    const glm::dvec3 world = place.to_world(position);
    const glm::dvec2 step = pixel_of(motion.after, width, height, world + way) -
                            pixel_of(motion.before, width, height, world - way);
    return {speed, step / motion.seconds};
}

} // namespace isomotion::render
