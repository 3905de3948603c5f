// Marches and shades a tile in one draw, for plain pictures whose rays end within one pass.
#pragma once

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
    // Draws into `result`, which must outlive it: colour, record and the attachments of `passes`.
    FusedPass(const synthesis::Passes& passes, const gpu::Target& result);

    // The shaders don't run in empty blocks. Their pixels are misses with the colour `background`.
    void draw(PassTable& table, const gpu::Rectangle& tile, const ScenePlan& plan,
              glm::vec4 background, const Blocks& blocks);

private:
    const gpu::Target& result_;
    std::vector<synthesis::Channel> channels_; // of the attachments from the third on
    gpu::Squares open_, settled_;
};

} // namespace isomotion::render
