#include "render/glass_paths.h"

namespace isomotion::render {
namespace {

using shader::Role;

constexpr int path_attachments = 4;    // shaders/glass/path.glsl
constexpr int surface_attachments = 3; // shaders/effects/surface_point.glsl

} // namespace

GlassPaths::GlassPaths(const shader::Passes& passes, const MarchPlan& tile, int depth)
    : depth_(depth)
    , rays_(passes, tile)
    , kept_(tile.target_width(), tile.target_height(), path_attachments)
    , gone_on_(tile.target_width(), tile.target_height(), path_attachments)
    , mask_(kept_) {
    for (const gpu::Target* target : {&gone_on_, &rays_.even, &rays_.odd}) mask_.serve(*target);
    if (passes.has(Role::glass_ground))
        ground_.emplace(tile.target_width(), tile.target_height(), surface_attachments);
}

bool GlassPaths::any_goes_on(PassTable& table, const gpu::Rectangle& tile) const {
    mask_.set(gone_on_, [&] { table.draw(table.program(Role::glass_mask), tile); });
    mask_.apply(gone_on_, [&] {
        still_active_.begin();
        table.draw(table.program(Role::glass_active), tile);
        still_active_.end();
    });
    return still_active_.passed() != 0;
}

void GlassPaths::trace(PassTable& table, const RayMarcher& marcher, const gpu::Rectangle& tile,
                       int& draws) const {
    const gpu::Program& first = table.program(Role::glass_first);
    first.set("rays_left", depth_);
    table.draw(first, tile, kept_);
    table.bind_numbered("glass_texture", kept_);
    for (int left = depth_ - 1; left >= 0 && any_goes_on(table, tile); --left) {
        // Active rays are counted under the same mask: states elsewhere are older.
        mask_.apply(rays_.even,
                    [&] { marcher.march(table, Role::glass, tile, rays_, gone_on_, draws); });
        const gpu::Program& next = table.program(Role::glass_next);
        next.set("rays_left", left);
        mask_.apply(gone_on_, [&] { table.draw(next, tile); });
        table.bind_numbered("glass_texture", gone_on_);
        mask_.apply(kept_, [&] { table.draw(table.program(Role::glass_copy), tile); });
        table.bind_numbered("glass_texture", kept_);
    }
}

const gpu::Target* GlassPaths::draw_ground(PassTable& table, const gpu::Rectangle& tile) const {
    if (!ground_) return nullptr;
    table.draw(table.program(Role::glass_ground), tile, *ground_);
    return &*ground_;
}

} // namespace isomotion::render
