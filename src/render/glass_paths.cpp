#include "render/glass_paths.h"

#include <utility>

namespace isomotion::render {
namespace {

using synthesis::Role;

constexpr int path_attachments = 4;    // shaders/glass/path.glsl
constexpr int surface_attachments = 3; // shaders/effects/surface_point.glsl

} // namespace

GlassPaths::GlassPaths(const synthesis::Passes& passes, const MarchPlan& tile, int depth)
    : depth_(depth)
    , rays_(passes, tile)
    , even_(tile.tile_width, tile.tile_height, path_attachments)
    , odd_(tile.tile_width, tile.tile_height, path_attachments) {
    if (passes.has(Role::glass_ground))
        ground_.emplace(tile.tile_width, tile.tile_height, surface_attachments);
}

bool GlassPaths::go_on(PassTable& table, const gpu::Rectangle& tile,
                       const gpu::Target& counted_into) const {
    counted_into.bind();
    still_active_.begin();
    table.draw(table.program(Role::glass_active), tile);
    still_active_.end();
    return still_active_.passed() != 0;
}

void GlassPaths::trace(PassTable& table, const RayMarcher& marcher, const gpu::Rectangle& tile,
                       const gpu::Target& counted_into, int& draws) const {
    const gpu::Target *from = &even_, *to = &odd_;
    const gpu::Program& first = table.program(Role::glass_first);
    first.set("rays_left", depth_);
    table.draw(first, tile, *from);
    table.bind_numbered("glass_texture", *from);
    for (int left = depth_ - 1; left >= 0 && go_on(table, tile, counted_into); --left) {
        marcher.march(table, Role::glass, tile, rays_, counted_into, draws);
        const gpu::Program& next = table.program(Role::glass_next);
        next.set("rays_left", left);
        table.draw(next, tile, *to);
        table.bind_numbered("glass_texture", *to);
        std::swap(from, to);
    }
}

const gpu::Target& GlassPaths::draw_ground(PassTable& table, const gpu::Rectangle& tile) const {
    table.draw(table.program(Role::glass_ground), tile, *ground_);
    return *ground_;
}

} // namespace isomotion::render
