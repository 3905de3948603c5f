// What the proofs of blocks of rays decide of whole blocks. Nothing is drawn for the rays of those.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/proof_outcome.h"

namespace isomotion::render {

// The last of the four numbers of a block's proof, where it is not a slope:
// shaders/proof/rounding.glsl.
inline constexpr float block_misses = -1, block_hits = -2;

struct ProvedBlocks {
    std::vector<glm::ivec2> open; // numbers of blocks that are not decided, row by row
    ProofCounts decided{};        // of the pixels of the others
};

// `blocks` has four numbers of each block of a tile of width x height pixels, row by row.
ProvedBlocks proved_blocks(std::span<const float> blocks, int width, int height);

// Writes what is decided of each pixel as the first of its four numbers in `record`; Proof::none
// where nothing is.
void write_proved_blocks(std::span<const float> blocks, int width, int height,
                         std::span<float> record);

} // namespace isomotion::render
