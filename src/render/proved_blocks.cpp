#include "render/proved_blocks.h"

#include <algorithm>

#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

constexpr int block = synthesis::proved_block;
static_assert(OpenSquares::side % block == 0);

Proof outcome_of(float last_number) {
    return last_number == block_hits     ? Proof::hit
           : last_number == block_misses ? Proof::miss
                                         : Proof::none;
}

// Reads outcomes of a tile's blocks.
class Outcomes {
public:
    Outcomes(std::span<const float> blocks, int width)
        : blocks_(blocks)
        , across_((width + block - 1) / block) {}

    Proof at(int x, int y) const { return outcome_of(last_number(x, y)); }
    bool is_monotone(int x, int y) const { return last_number(x, y) > 0; }

private:
    float last_number(int x, int y) const {
        const int k = y / block * across_ + x / block;
        return blocks_[4 * std::size_t(k) + 3];
    }

    std::span<const float> blocks_;
    int across_;
};

} // namespace

ProvedBlocks proved_blocks(std::span<const float> blocks, int width, int height) {
    constexpr int side = OpenSquares::side;
    const Outcomes outcomes(blocks, width);
    ProvedBlocks found;
    for (int low = 0; low < height; low += side) {
        const int top = std::min(low + side, height);
        for (int left = 0; left < width; left += side) {
            const int right = std::min(left + side, width);
            ProofCounts counts{};
            int monotone = 0;
            for (int y = low; y < top; y += block) {
                for (int x = left; x < right; x += block) {
                    const int pixels =
                        (std::min(x + block, right) - x) * (std::min(y + block, top) - y);
                    counts[std::size_t(outcomes.at(x, y))] += pixels;
                    if (outcomes.is_monotone(x, y)) monotone += pixels;
                }
            }
            const std::int64_t open = counts[std::size_t(Proof::none)];
            if (open > 0) {
                found.left.add({left, low, right - left, top - low});
                found.left.pixels += int(open);
                if (monotone > 0) found.monotone.add({left, low, right - left, top - low});
                found.monotone.pixels += monotone;
                continue;
            }
            for (std::size_t k = 0; k < counts.size(); ++k) found.outside[k] += counts[k];
        }
    }
    return found;
}

void write_proved_blocks(std::span<const float> blocks, int width, int height,
                         std::span<float> record) {
    const Outcomes outcomes(blocks, width);
    std::ranges::fill(record, 0.0f);
    for (int y = 0; y < height; ++y) {
        float* row = record.data() + 4 * std::size_t(y) * std::size_t(width);
        for (int x = 0; x < width; ++x) row[4 * x] = float(outcomes.at(x, y));
    }
}

void write_proved_blocks(std::span<const float> blocks, int width,
                         std::span<const gpu::Rectangle> areas, std::span<float> texels) {
    const Outcomes outcomes(blocks, width);
    for (const gpu::Rectangle& area : areas) {
        const int right = area.x + area.width;
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < right; x += block) {
                const auto part = texels.first(4 * std::size_t(std::min(block, right - x)));
                texels = texels.subspan(part.size());
                const Proof decided = outcomes.at(x, y);
                if (decided == Proof::none) continue;
                for (std::size_t k = 0; k < part.size(); k += 4) part[k] = float(decided);
            }
        }
    }
}

} // namespace isomotion::render
