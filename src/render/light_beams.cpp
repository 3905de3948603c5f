#include "render/light_beams.h"

#include <algorithm>

#include "render/uniform_blocks.h"

namespace isomotion::render {
namespace {

// All of the bounds, as the light sees them.
scene::SceneAt seen_from(const scene::LightAt& light, const scene::SurfaceAt& now) {
    scene::SceneAt view;
    const double radius = now.bounds.radius * now.placement.scale;
    scene::CameraAt& camera = view.camera;
    camera.projection = scene::Camera::Projection::orthographic;
    camera.target = now.placement.to_world(now.bounds.centre);
    camera.position = camera.target + 2 * radius * light.direction;
    camera.up = std::abs(light.direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    camera.height = 2.02 * radius;
    return view;
}

glm::vec4 row(const glm::dvec3& v, double w) { return glm::vec4(glm::dvec4(v, w)); }

double square(const glm::dvec3& v) { return glm::dot(v, v); }

// How a place of the surface finds its texel in the light's picture.
std::array<glm::vec4, 4> to_light(const scene::OneSurfaceAt& view, int pixels) {
    const scene::Rays rays = scene::rays(view, pixels, pixels);
    const double half = 0.5 * pixels, rounding = beam_range(view, pixels, pixels, {}, 1).w;
    const glm::vec4 across = row(half / square(rays.right) * rays.right, half);
    // Farther away rounding would take a place for its neighbour block's.
    constexpr double radii = 16;
    return {across,
            row(half / square(rays.up) * rays.up, radii * half / length(glm::dvec3(across))),
            row(rays.axis / square(rays.axis), glm::length(rays.axis)), row(rays.origin, rounding)};
}

} // namespace

int light_pixels(int width, int height) {
    // As fine as the eye's picture.
    const int squares = (std::min(width, height) + BeamPass::square - 1) / BeamPass::square;
    return BeamPass::square * std::clamp(squares, 1, 8);
}

std::vector<LightInputs> light_inputs(const scene::OneSurface& one, const scene::OneSurfaceAt& now,
                                      const shader::Passes& passes, int pixels) {
    std::vector<LightInputs> inputs;
    for (std::size_t k = 0; k < now.scene.lights.size(); ++k) {
        if ((passes.light_beams >> k & 1) == 0) continue;
        const scene::SceneAt from = seen_from(now.scene.lights[k], now.surface);
        const scene::OneSurfaceAt view(from, now.surface);
        inputs.push_back({int(k), view_inputs(one, view, pixels, pixels, {}, passes, nullptr),
                          to_light(view, pixels)});
    }
    return inputs;
}

LightBeams::LightBeams(const shader::Passes& passes, const scene::OneSurface& one, int pixels,
                       int texels, int first_list)
    : most_pixels_(pixels)
    , beams_(passes, one, {pixels, pixels * int(one.scene.lights.size()), 0}, texels, first_list)
    , frame_(sizeof(FrameBlock))
    , to_light_(one.scene.lights.size() * 4) {}

void LightBeams::draw(PassTable& table, const std::vector<LightInputs>& lights, int pixels,
                      const ArrayBuffer* array) {
    for (const LightInputs& light : lights) {
        frame_.update(std::as_bytes(std::span(&light.view.frame, 1)));
        const PassTable::Instead as_seen_from_there(table, "Frame", frame_);
        // Rays are anywhere in a block, and at its edge rounding may take them for the next one's.
        const int below = light.light * pixels;
        beams_.draw(table, light.view.beams, {0, below, pixels, pixels}, {0, -below}, array, 0.51);
        std::copy(light.to_light.begin(), light.to_light.end(),
                  &to_light_[std::size_t(4 * light.light)]);
    }
    bind(table);
    table.program(shader::Role::shadow).set("light_views", std::span<const glm::vec4>(to_light_));
}

} // namespace isomotion::render
