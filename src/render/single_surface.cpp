#include "render/single_surface.h"

namespace isomotion::render {

using shader::Role;

SingleSurface::SingleSurface(SurfacePasses& only)
    : only_(only)
    , eye_(only.passes, only.plan.march) {
    if (only.passes.has(Role::surface))
        secondary_.emplace(only.passes, only.drawn, only.plan.march);
}

void SingleSurface::draw(const PictureInputs& inputs, const gpu::Rectangle& tile,
                         const gpu::Target& result, const gpu::Texture*, int& draws) {
    PassTable& table = only_.table; // has the environment with the inputs
    only_.draw_beams(inputs.surfaces.front(), tile);
    rays_ = &only_.marcher.march(table, Role::march, tile, eye_, result, draws);
    if (secondary_) secondary_->trace(table, only_.marcher, tile, result, draws);
    table.bind_numbered("state_texture", *rays_);
    table.draw(table.program(Role::shade), tile, result);
}

const gpu::Target& SingleSurface::rays(std::size_t) const { return *rays_; }

std::vector<int> SingleSurface::seen(const gpu::Rectangle& tile) const {
    return std::vector<int>(std::size_t(tile.width) * std::size_t(tile.height), 0);
}

} // namespace isomotion::render
