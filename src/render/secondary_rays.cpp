#include "render/secondary_rays.h"

#include "render/ray_pass.h"

namespace isomotion::render {
namespace {

enum Unit { unit_surface, unit_mirrored = 3, unit_shadow = 6 };

constexpr int attachments = 3; // of what is kept of an end, see shaders/effects/surface_point.glsl

} // namespace

SecondaryRays::SecondaryRays(const synthesis::Shaders& shaders, int width, int height,
                             int first_unit)
    : first_unit_(first_unit)
    , surface_(shaders.vertex, shaders.surface, "surface")
    , ends_(width, height, attachments) {
    if (!shaders.mirror.empty()) {
        mirror_ = Mirror{ray_program(shaders, shaders.mirror, "mirror"),
                         gpu::Program(shaders.vertex, shaders.mirror_surface, "mirror surface"),
                         RayTargets(width, height, shaders.state_textures),
                         gpu::Target(width, height, attachments)};
    }
    if (!shaders.shadow.empty()) {
        shadow_ = Shadow{ray_program(shaders, shaders.shadow, "shadow"),
                         RayTargets(width, height, shaders.state_textures)};
    }
    for_each_program([&](const gpu::Program& program) { connect(program); });
}

void SecondaryRays::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    visit(surface_);
    if (mirror_) {
        visit(mirror_->march);
        visit(mirror_->surface);
    }
    if (shadow_) visit(shadow_->march);
}

void SecondaryRays::connect(const gpu::Program& program) const {
    for (int k = 0; k < attachments; ++k) {
        const std::string number = std::to_string(k);
        program.bind_sampler("surface_texture_" + number, first_unit_ + unit_surface + k);
        program.bind_sampler("mirrored_texture_" + number, first_unit_ + unit_mirrored + k);
    }
    program.bind_sampler("shadow_texture", first_unit_ + unit_shadow);
}

void SecondaryRays::trace(const gpu::Rectangle& tile, const gpu::Target& eye_rays,
                          const MarchRays& march) {
    keep_ends(surface_, tile, eye_rays, ends_);
    for (int k = 0; k < attachments; ++k) {
        ends_.texture(k).bind(first_unit_ + unit_surface + k);
    }
    if (mirror_) {
        const gpu::Target& rays = march(mirror_->march, mirror_->rays);
        keep_ends(mirror_->surface, tile, rays, mirror_->ends);
        for (int k = 0; k < attachments; ++k) {
            mirror_->ends.texture(k).bind(first_unit_ + unit_mirrored + k);
        }
    }
    if (shadow_) {
        march(shadow_->march, shadow_->rays).texture(1).bind(first_unit_ + unit_shadow);
    }
}

void SecondaryRays::keep_ends(const gpu::Program& program, const gpu::Rectangle& tile,
                              const gpu::Target& rays, const gpu::Target& into) const {
    rays.texture(0).bind(0);
    rays.texture(1).bind(1);
    into.bind();
    gpu::set_viewport({0, 0, tile.width, tile.height});
    program.set("tile_origin", glm::ivec2(tile.x, tile.y));
    program.use();
    triangle_.draw();
}

} // namespace isomotion::render
