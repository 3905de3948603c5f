// What the proofs of blocks of rays decide of whole blocks. Where they decide all of a square,
// nothing is drawn for its rays.
#pragma once

#include <span>

#include "render/open_squares.h"
#include "render/proof_outcome.h"

namespace isomotion::render {

// The last of the four numbers of a block's proof, where it is not a slope:
// shaders/proof/block_outcome.glsl.
inline constexpr float block_misses = -1, block_hits = -2;

struct ProvedBlocks {
    OpenSquares left;      // with a block that is not decided, whose pixels are open
    OpenSquares monotone;  // those with a block in which F is proved monotone around the roots
    ProofCounts outside{}; // of the pixels elsewhere
};

// `blocks` has four numbers of each block of a tile of width x height pixels, row by row.
ProvedBlocks proved_blocks(std::span<const float> blocks, int width, int height);

// Writes what is decided of each pixel as the first of its four numbers in `record`; Proof::none
// where nothing is.
void write_proved_blocks(std::span<const float> blocks, int width, int height,
                         std::span<float> record);

// Writes the same over what is decided in `areas`, whose records `texels` holds one after another.
void write_proved_blocks(std::span<const float> blocks, int width,
                         std::span<const gpu::Rectangle> areas, std::span<float> texels);

} // namespace isomotion::render
