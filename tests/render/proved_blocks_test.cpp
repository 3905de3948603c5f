#include "render/proved_blocks.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "synthesis/proof_text.h"
#include "synthesis/shader_files.h"

namespace isomotion::render::proved_blocks_test {
namespace {

constexpr int block = synthesis::proved_block;

TEST(ProvedBlocks, HaveTheCodesOfTheShaders) {
    const std::string text = synthesis::read_shader("proof/block_outcome.glsl");
    EXPECT_NE(text.find("BLOCK_MISSES = -1.0;"), std::string::npos);
    EXPECT_NE(text.find("BLOCK_HITS = -2.0;"), std::string::npos);
    EXPECT_EQ(block_misses, -1.0f);
    EXPECT_EQ(block_hits, -2.0f);
}

// A slope, which is not negative, decides nothing; nor does NaN.
TEST(ProvedBlocks, LeaveSquaresWithAnUndecidedBlock) {
    for (const float undecided : {0.0f, 3.5f, -1.5f, NAN}) {
        std::vector<float> blocks(4 * 8 * 8, block_misses); // 32 x 32 pixels
        blocks[4 * (5 * 8 + 1) + 3] = undecided;
        blocks[4 * (7 * 8 + 7) + 3] = block_hits;
        const ProvedBlocks found = proved_blocks(blocks, 32, 32);
        ASSERT_EQ(found.left.areas.size(), 1u);
        EXPECT_EQ(found.left.areas[0].x, 0);
        EXPECT_EQ(found.left.areas[0].y, 16);
        EXPECT_EQ(found.left.areas[0].width, 16);
        EXPECT_EQ(found.left.pixels, 16);
        EXPECT_EQ(found.outside[std::size_t(Proof::hit)], 16);
        EXPECT_EQ(found.outside[std::size_t(Proof::miss)], 3 * 256 - 16);
    }
}

// Only a slope that is not 0 tells that F is monotone.
TEST(ProvedBlocks, TellWhereFIsMonotone) {
    for (const auto& [slope, pixels] :
         {std::pair(0.0f, 0), {3.5f, 16}, {-1.5f, 0}, {NAN, 0}, {block_hits, 0}}) {
        std::vector<float> blocks(4 * 8 * 8, block_misses); // 32 x 32 pixels
        blocks[4 * 3 + 3] = 0;
        blocks[4 * (5 * 8 + 6) + 3] = slope;
        const ProvedBlocks found = proved_blocks(blocks, 32, 32);
        EXPECT_EQ(found.monotone.pixels, pixels);
        ASSERT_EQ(found.monotone.areas.size(), pixels > 0 ? 1u : 0u);
        if (pixels > 0) {
            EXPECT_EQ(found.monotone.areas[0].x, 16);
            EXPECT_EQ(found.monotone.areas[0].y, 16);
        }
    }
}

// Each pixel either lies in an area or counts outside with what its block decides.
TEST(ProvedBlocks, CountEveryPixelOnce) {
    constexpr unsigned seed = 20261127;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const auto& [width, height] : {std::pair(1, 1), {16, 16}, {17, 15}, {64, 33}, {5, 90}}) {
        const int across = (width + block - 1) / block, up = (height + block - 1) / block;
        std::vector<float> blocks(std::size_t(4 * across * up), 7.0f); // other numbers don't count
        for (std::size_t k = 3; k < blocks.size(); k += 4) {
            const unsigned kind = random() % 40;
            blocks[k] = kind == 0 ? 1.0f : kind < 20 ? block_hits : block_misses;
        }
        std::vector<float> record(std::size_t(4 * width * height), -9.0f);
        write_proved_blocks(blocks, width, height, record);
        const ProvedBlocks found = proved_blocks(blocks, width, height);
        std::vector<float> of_areas;
        for (const gpu::Rectangle& area : found.left.areas)
            of_areas.resize(of_areas.size() + std::size_t(4 * area.width * area.height), -9.0f);
        write_proved_blocks(blocks, width, found.left.areas, of_areas);
        auto of_pixel = of_areas.begin();
        std::vector<bool> left(std::size_t(width * height));
        for (const gpu::Rectangle& area : found.left.areas) {
            for (int y = area.y; y < area.y + area.height; ++y)
                for (int x = area.x; x < area.x + area.width; ++x) {
                    EXPECT_FALSE(left[std::size_t(y * width + x)]) << "in two areas";
                    left[std::size_t(y * width + x)] = true;
                    const float decided = record[std::size_t(4 * (y * width + x))];
                    EXPECT_EQ(*of_pixel, decided == float(Proof::none) ? -9.0f : decided);
                    of_pixel += 4;
                }
        }
        ProofCounts outside{};
        int open = 0;
        for (int k = 0; k < width * height; ++k) {
            const int of_block = k / width / block * across + k % width / block;
            const float code = blocks[std::size_t(4 * of_block) + 3];
            const Proof decided = code == block_hits     ? Proof::hit
                                  : code == block_misses ? Proof::miss
                                                         : Proof::none;
            EXPECT_EQ(record[std::size_t(4 * k)], float(decided));
            if (decided == Proof::none) {
                EXPECT_TRUE(left[std::size_t(k)]);
            }
            open += decided == Proof::none;
            if (!left[std::size_t(k)]) {
                ++outside[std::size_t(decided)];
            }
        }
        EXPECT_EQ(found.outside, outside);
        EXPECT_EQ(found.left.pixels, open);
    }
}

} // namespace
} // namespace isomotion::render::proved_blocks_test
