#include "render/secondary_rays.h"

namespace isomotion::render {
namespace {

using shader::Role;

constexpr int attachments = 3; // of what is kept of an end, see shaders/effects/surface_point.glsl

} // namespace

SecondaryRays::SecondaryRays(const shader::Passes& passes, const scene::OneSurface& one,
                             const MarchPlan& tile)
    : ends_(tile.target_width(), tile.target_height(), attachments) {
    if (passes.has(Role::shadow)) shadow_.emplace(passes, tile);
    if (passes.has(Role::mirror)) {
        mirror_ = Mirror{RayTargets(passes, tile),
                         gpu::Target(tile.target_width(), tile.target_height(), attachments),
                         std::nullopt};
        if (shadow_) mirror_->shadows.emplace(passes, tile);
    }
    const auto& glass = one.surface.material.glass;
    if (glass && passes.has(Role::glass)) glass_.emplace(passes, tile, glass->depth);
    if (passes.has(Role::glass_ground)) shadow_through_glass_.emplace(passes, tile);
}

void SecondaryRays::trace(PassTable& table, const RayMarcher& marcher, const gpu::Rectangle& tile,
                          const gpu::Target& counted_into, int& draws) const {
    table.draw(table.program(Role::surface), tile, ends_);
    table.bind_numbered("surface_texture", ends_);
    if (mirror_) {
        marcher.march(table, Role::mirror, tile, mirror_->rays, counted_into, draws);
        table.draw(table.program(Role::mirror_surface), tile, mirror_->ends);
        table.bind_numbered("mirrored_texture", mirror_->ends);
    }
    if (glass_) glass_->trace(table, marcher, tile, draws);
    const auto trace_shadows = [&](const gpu::Target& from, const RayTargets& rays,
                                   const char* seen_as) {
        table.bind_numbered("surface_texture", from);
        const gpu::Target& ended =
            marcher.march(table, Role::shadow, tile, rays, counted_into, draws);
        table.bind(seen_as, ended.texture(1));
    };
    if (mirror_ && mirror_->shadows)
        trace_shadows(mirror_->ends, *mirror_->shadows, "mirrored_shadow_texture");
    const gpu::Target* ground = glass_ ? glass_->draw_ground(table, tile) : nullptr;
    if (ground && shadow_through_glass_)
        trace_shadows(*ground, *shadow_through_glass_, "glass_shadow_texture");
    if (shadow_) trace_shadows(ends_, *shadow_, "shadow_texture");
}

} // namespace isomotion::render
