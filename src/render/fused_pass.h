// Marches and shades a tile of a single surface in one draw, for plain pictures whose rays end
// within one pass.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "gpu/squares.h"
#include "gpu/target.h"
#include "render/block_squares.h"
#include "render/drawing_route.h"
#include "render/surface_passes.h"

namespace isomotion::render {

// Makes a target with colour, record and these channels what shaders write of rays that end on
// nothing before they are marched.
void clear_to_misses(const gpu::Target& target, const std::vector<shader::Channel>& channels,
                     glm::vec4 background);

class FusedPass : public OneDraw {
public:
    // Draws into `result`, which must outlive it and be drawn into by nothing else: colour, record
    // and the attachments of the surface's passes. `reads_at_once`: see BeamPass::blocks().
    FusedPass(SurfacePasses& only, const gpu::Target& result, bool reads_at_once);

    // The shaders don't run in empty blocks. Their pixels are misses with the background's colour.
    void draw(const PictureInputs& inputs, const gpu::Rectangle& tile, int& draws) override;

private:
    // The draw before, which left the pixels of its empty blocks as misses.
    struct Before {
        gpu::Rectangle area; // of the target
        glm::vec4 background;
        Blocks blocks;
    };

    // The blocks to draw: those that aren't empty, and, as open ones, those that were not before.
    // Clears the target if it doesn't hold misses elsewhere.
    Blocks blocks_to_draw(const gpu::Rectangle& area, glm::vec4 background, const Blocks& blocks);

    SurfacePasses& only_;
    const gpu::Target& result_;
    bool reads_at_once_;
    std::optional<Before> before_;
    gpu::Squares open_, settled_;
};

} // namespace isomotion::render
