#include "render/light_beams.h"

#include <algorithm>

#include "render/blocks.h"

namespace isomotion::render {
namespace {

// As fine as the eye's picture.
int pixels_of(int width, int height) {
    const int squares = (std::min(width, height) + BeamPass::square - 1) / BeamPass::square;
    return BeamPass::square * std::clamp(squares, 1, 8);
}

// All of the bounds, as the light sees them.
scene::SceneAt seen_from(const scene::LightAt& light, const scene::SceneAt& now) {
    scene::SceneAt view = now;
    const double radius = now.bounds.radius * now.placement.scale;
    scene::CameraAt& camera = view.camera;
    camera = {};
    camera.projection = scene::Camera::Projection::orthographic;
    camera.target = now.placement.to_world(now.bounds.centre);
    camera.position = camera.target + 2 * radius * light.direction;
    camera.up = std::abs(light.direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    camera.height = 2.02 * radius;
    return view;
}

glm::vec4 wide(const glm::dvec3& v, double w) { return glm::vec4(glm::dvec4(v, w)); }

double square(const glm::dvec3& v) { return glm::dot(v, v); }

} // namespace

LightBeams::LightBeams(const BeamPass& eye, const synthesis::Shaders& shaders, int lights,
                       int width, int height, int texels)
    : mask_(shaders.light_beams)
    , most_(pixels_of(width, height))
    , pixels_(most_)
    , beams_(eye, shaders, most_, most_ * lights, texels)
    , frame_(sizeof(FrameBlock))
    , views_(std::size_t(lights) * 4) {}

void LightBeams::resize(int width, int height) {
    pixels_ = std::min(most_, pixels_of(width, height));
}

void LightBeams::draw(const scene::Scene& scene, const scene::SceneAt& now, unsigned binding,
                      const ArrayBuffer* array) {
    for (std::size_t k = 0; k < now.lights.size(); ++k) {
        if ((mask_ >> k & 1) == 0) continue;
        const scene::SceneAt view = seen_from(now.lights[k], now);
        const FrameBlock block = frame_block(scene, view, pixels_, pixels_);
        frame_.update(std::as_bytes(std::span(&block, 1)));
        frame_.bind(binding);
        // Rays are anywhere in a block, and at its edge rounding may take them for the next one's.
        beams_.upload(view, pixels_, pixels_, {}, 0.51);
        const int below = int(k) * pixels_;
        beams_.draw({0, below, pixels_, pixels_}, {0, -below}, array);

        const scene::Rays rays = scene::rays(view, pixels_, pixels_);
        const double half = 0.5 * pixels_, rounding = beam_range(view, pixels_, pixels_, {}, 1).w;
        glm::vec4* to = &views_[4 * k];
        to[0] = wide(half / square(rays.right) * rays.right, half);
        // Farther away rounding would take a place for its neighbour block's.
        constexpr double radii = 16;
        to[1] = wide(half / square(rays.up) * rays.up, radii * half / length(glm::dvec3(to[0])));
        to[2] = wide(rays.axis / square(rays.axis), glm::length(rays.axis));
        to[3] = wide(rays.origin, rounding);
    }
}

void LightBeams::connect(const gpu::Program& program, int unit) const {
    program.bind_sampler("light_beam_texture", unit);
    program.bind_sampler("light_lists_texture", unit + 1);
    program.bind_sampler("light_all_texture", unit + 2);
}

void LightBeams::set_views(const gpu::Program& program) const {
    program.set("light_views", std::span<const glm::vec4>(views_));
}

} // namespace isomotion::render
