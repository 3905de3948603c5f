// Which blocks of 8 x 8 pixels a tile's rays have to be marched in, as squares to draw.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/draw.h"
#include "gpu/squares.h"
#include "render/uniform_blocks.h"

namespace isomotion::render {

enum class BlockKind : std::uint8_t {
    empty,   // no ray of it has a root
    open,    // rays march
    settled, // each ray has its first root in a known piece: shaders/march/beam_by_models.glsl
};

struct Blocks {
    static constexpr int side = 8; // pixels

    Blocks(int width, int height)
        : across((width + side - 1) / side)
        , up((height + side - 1) / side)
        , kinds(std::size_t(across) * std::size_t(up)) {}

    BlockKind& at(int x, int y) {
        return kinds[std::size_t(y) * std::size_t(across) + std::size_t(x)];
    }
    BlockKind at(int x, int y) const {
        return kinds[std::size_t(y) * std::size_t(across) + std::size_t(x)];
    }

    int across, up;
    std::vector<BlockKind> kinds; // rows from the bottom
};

// All blocks of that kind, neighbours joined to larger squares. Those at the upper and right edges
// may reach over these.
std::vector<gpu::Square> squares_of(const Blocks& blocks, BlockKind kind);

// The blocks of a tile through which a ray may meet the bounds; the others are empty. `is_box`: the
// bounds are a box, otherwise a sphere.
Blocks blocks_in_bounds(const FrameBlock& frame, bool is_box, const gpu::Rectangle& tile);

} // namespace isomotion::render
