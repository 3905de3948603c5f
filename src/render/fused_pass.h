// Marches and shades a tile in one draw, for plain pictures whose rays end within one pass.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "gpu/squares.h"
#include "gpu/target.h"
#include "render/block_squares.h"
#include "render/pass_table.h"
#include "render/scene_plan.h"

namespace isomotion::render {

// Makes a target with colour, record and these channels what shaders write of rays that end on
// nothing before they are marched.
void clear_to_misses(const gpu::Target& target, const std::vector<synthesis::Channel>& channels,
                     glm::vec4 background);

class FusedPass {
public:
    // Draws into `result`, which must outlive it and be drawn into by nothing else: colour, record
    // and the attachments of `passes`.
    FusedPass(const synthesis::Passes& passes, const gpu::Target& result);

    // The shaders don't run in empty blocks. Their pixels are misses with the colour `background`.
    void draw(PassTable& table, const gpu::Rectangle& tile, const ScenePlan& plan,
              glm::vec4 background, const Blocks& blocks);

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

    const gpu::Target& result_;
    std::optional<Before> before_;
    std::vector<synthesis::Channel> channels_; // of the attachments from the third on
    gpu::Squares open_, settled_;
};

} // namespace isomotion::render
