#include "render/fused_pass.h"

#include <limits>

#include "render/renderer.h"

namespace isomotion::render {

using shader::Channel, shader::Role;

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

FusedPass::FusedPass(SurfacePasses& only, const gpu::Target& result, bool reads_at_once)
    : only_(only)
    , result_(result)
    , reads_at_once_(reads_at_once) {}

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
        clear_to_misses(result_, only_.passes.attachments, background);
    }
    before_ = {area, background, blocks};
    return drawn;
}

void FusedPass::draw(const PictureInputs& inputs, const gpu::Rectangle& tile, int& draws) {
    PassTable& table = only_.table;
    const SurfaceInputs& surface = inputs.surfaces.front();
    only_.draw_beams(surface, tile);
    const gpu::Rectangle area = table.in_targets(tile);
    const bool is_box = only_.drawn.surface.bounds.shape == scene::Bounds::Shape::box;
    const bool by_beams = only_.beams && only_.passes.beams.back().block == Blocks::side;
    table.timed([&] {
        const Blocks drawn =
            blocks_to_draw(area, inputs.background(),
                           by_beams ? only_.beams->blocks(area, reads_at_once_)
                                    : blocks_in_bounds(surface.eye.frame, is_box, tile));
        const auto draw_blocks = [&](Role role, BlockKind kind, gpu::Squares& squares) {
            const gpu::Program& program = table.program(role);
            program.set("evaluations_per_pass", only_.plan.march.evaluations_per_pass);
            program.set("element_budget", only_.plan.element_budget);
            squares.set(squares_of(drawn, kind));
            table.draw(program, tile, squares);
        };
        result_.bind();
        draw_blocks(Role::fused, BlockKind::open, open_);
        if (table.has(Role::settled)) draw_blocks(Role::settled, BlockKind::settled, settled_);
    });
    ++draws;
}

} // namespace isomotion::render
