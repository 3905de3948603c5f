// The ways to draw a tile of a picture whose inputs are uploaded.
//
// Plain pictures are marched and shaded in one draw of each surface. Where rays need longer, or
// other rays begin where they end, a tile is drawn in passes.
#pragma once

#include <cstddef>
#include <vector>

#include "gpu/target.h"
#include "gpu/texture.h"
#include "render/frame_inputs.h"

namespace isomotion::render {

// Draws into a target that it was made for. Rays that have not ended are told by the record; then
// the tile is to be drawn in passes.
class OneDraw {
public:
    virtual ~OneDraw() = default;
    // Adds its draws to `draws`.
    virtual void draw(const PictureInputs& inputs, const gpu::Rectangle& tile, int& draws) = 0;
};

class InPasses {
public:
    virtual ~InPasses() = default;
    // `environment`: the scene's map, if it has one. Adds its march draws to `draws`.
    virtual void draw(const PictureInputs& inputs, const gpu::Rectangle& tile,
                      const gpu::Target& result, const gpu::Texture* environment, int& draws) = 0;

    // Of the tile drawn last: where the eye's rays ended on one surface, and the index of the
    // surface that is seen at each pixel, row by row from the lower left.
    virtual const gpu::Target& rays(std::size_t surface) const = 0;
    virtual std::vector<int> seen(const gpu::Rectangle& tile) const = 0;
};

} // namespace isomotion::render
