#include "render/proved_blocks.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "shader/proof_text.h"
#include "shader/shader_files.h"

namespace isomotion::render::proved_blocks_test {
namespace {

constexpr int block = shader::proved_block;

TEST(ProvedBlocks, HaveTheCodesOfTheShaders) {
    const std::string text = shader::read_shader("proof/rounding.glsl");
    EXPECT_NE(text.find("BLOCK_MISSES = -1.0;"), std::string::npos);
    EXPECT_NE(text.find("BLOCK_HITS = -2.0;"), std::string::npos);
    EXPECT_EQ(block_misses, -1.0f);
    EXPECT_EQ(block_hits, -2.0f);
}

// A slope, which is not negative, decides nothing; nor does NaN.
TEST(ProvedBlocks, LeaveBlocksThatAreNotDecided) {
    for (const float undecided : {0.0f, 3.5f, -1.5f, NAN}) {
        std::vector<float> blocks(4 * 8 * 8, block_misses); // 32 x 32 pixels
        blocks[4 * (5 * 8 + 1) + 3] = undecided;
        blocks[4 * (7 * 8 + 7) + 3] = block_hits;
        const ProvedBlocks found = proved_blocks(blocks, 32, 32);
        ASSERT_EQ(found.open.size(), 1u);
        EXPECT_EQ(found.open[0], glm::ivec2(1, 5));
        EXPECT_EQ(found.decided[std::size_t(Proof::hit)], 16);
        EXPECT_EQ(found.decided[std::size_t(Proof::miss)], 32 * 32 - 2 * 16);
    }
}

// Each pixel either is of an open block or counts with what its block decides.
TEST(ProvedBlocks, CountEveryPixelOnce) {
    constexpr unsigned seed = 20261127;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const auto& [width, height] : {std::pair(1, 1), {16, 16}, {17, 15}, {64, 33}, {5, 90}}) {
        const int across = (width + block - 1) / block, up = (height + block - 1) / block;
        std::vector<float> blocks(std::size_t(4 * across * up), 7.0f); // other numbers don't count
        for (std::size_t k = 3; k < blocks.size(); k += 4) {
            const unsigned kind = random() % 40;
            blocks[k] = kind < 4 ? 1.0f : kind < 20 ? block_hits : block_misses;
        }
        std::vector<float> record(std::size_t(4 * width * height), -9.0f);
        write_proved_blocks(blocks, width, height, record);
        const ProvedBlocks found = proved_blocks(blocks, width, height);
        std::vector<int> open(std::size_t(across * up));
        for (const glm::ivec2& one : found.open) ++open[std::size_t(one.y * across + one.x)];
        ProofCounts decided{};
        for (int k = 0; k < width * height; ++k) {
            const int of_block = k / width / block * across + k % width / block;
            const float code = blocks[std::size_t(4 * of_block) + 3];
            const Proof outcome = code == block_hits     ? Proof::hit
                                  : code == block_misses ? Proof::miss
                                                         : Proof::none;
            EXPECT_EQ(record[std::size_t(4 * k)], float(outcome));
            EXPECT_EQ(open[std::size_t(of_block)], outcome == Proof::none ? 1 : 0);
            if (outcome != Proof::none) {
                ++decided[std::size_t(outcome)];
            }
        }
        EXPECT_EQ(found.decided, decided);
    }
}

} // namespace
} // namespace isomotion::render::proved_blocks_test
