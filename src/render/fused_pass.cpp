#include "render/fused_pass.h"

#include <limits>

#include "render/renderer.h"

namespace isomotion::render {

using synthesis::Channel, synthesis::Role;

void clear_to_misses(const gpu::Target& target, const std::vector<Channel>& channels,
                     glm::vec4 background) {
    target.clear(0, background);
    target.clear(1, 0u);
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const float none = channels[k] == Channel::depth    ? std::numeric_limits<float>::infinity()
                           : channels[k] == Channel::ending ? Ending::nowhere
                                                            : 0.0f;
        target.clear(2 + int(k), glm::vec4(none, 0, 0, 0));
    }
}

FusedPass::FusedPass(const synthesis::Passes& passes, const gpu::Target& result)
    : result_(result)
    , channels_(passes.attachments) {}

// Mesa's software renderer clears pixels of 16 bytes one by one, which takes a tenth of a cheap
// frame or more. From one frame to the next few blocks become empty.
Blocks FusedPass::blocks_to_draw(const gpu::Rectangle& area, glm::vec4 background,
                                 const Blocks& blocks) {
    Blocks drawn = blocks;
    if (before_ && before_->area == area && before_->background == background) {
        for (std::size_t k = 0; k < drawn.kinds.size(); ++k) {
            const bool is_left = before_->blocks.kinds[k] != BlockKind::empty;
            if (is_left && blocks.kinds[k] == BlockKind::empty) drawn.kinds[k] = BlockKind::open;
        }
    } else {
        clear_to_misses(result_, channels_, background);
    }
    before_ = {area, background, blocks};
    return drawn;
}

void FusedPass::draw(PassTable& table, const gpu::Rectangle& tile, const ScenePlan& plan,
                     glm::vec4 background, const Blocks& blocks) {
    const Blocks drawn = blocks_to_draw(table.in_targets(tile), background, blocks);
    const auto draw = [&](Role role, BlockKind kind, gpu::Squares& squares) {
        const gpu::Program& program = table.program(role);
        program.set("evaluations_per_pass", plan.march.evaluations_per_pass);
        program.set("element_budget", plan.element_budget);
        squares.set(squares_of(drawn, kind));
        table.draw(program, tile, squares);
    };
    result_.bind();
    draw(Role::fused, BlockKind::open, open_);
    if (table.has(Role::settled)) draw(Role::settled, BlockKind::settled, settled_);
}

} // namespace isomotion::render
