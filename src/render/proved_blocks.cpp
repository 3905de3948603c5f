#include "render/proved_blocks.h"

#include <algorithm>

#include "shader/proof_text.h"

namespace isomotion::render {
namespace {

constexpr int block = shader::proved_block;

// The outcome of a pixel's block in a tile of so many pixels across.
Proof outcome_at(std::span<const float> blocks, int width, int x, int y) {
    const int k = y / block * ((width + block - 1) / block) + x / block;
    const float last_number = blocks[4 * std::size_t(k) + 3];
    return last_number == block_hits     ? Proof::hit
           : last_number == block_misses ? Proof::miss
                                         : Proof::none;
}

} // namespace

ProvedBlocks proved_blocks(std::span<const float> blocks, int width, int height) {
    ProvedBlocks found;
    for (int y = 0; y < height; y += block) {
        for (int x = 0; x < width; x += block) {
            const Proof outcome = outcome_at(blocks, width, x, y);
            if (outcome == Proof::none) {
                found.open.emplace_back(x / block, y / block);
            } else {
                found.decided[std::size_t(outcome)] +=
                    std::min(block, width - x) * std::min(block, height - y);
            }
        }
    }
    return found;
}

void write_proved_blocks(std::span<const float> blocks, int width, int height,
                         std::span<float> record) {
    std::ranges::fill(record, 0.0f);
    for (int y = 0; y < height; ++y) {
        float* row = record.data() + 4 * std::size_t(y) * std::size_t(width);
        for (int x = 0; x < width; ++x) row[4 * x] = float(outcome_at(blocks, width, x, y));
    }
}

} // namespace isomotion::render
