// Chunks are the sequence: every frame once, in its order, and no worker stands idle.
#include "farm/chunks.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "animation/frame_range.h"

namespace isomotion::farm {
namespace {

std::vector<int> counted(int frames) {
    std::vector<int> all(static_cast<std::size_t>(frames));
    std::iota(all.begin(), all.end(), 1);
    return all;
}

std::vector<int> joined(const std::vector<Chunk>& chunks) {
    std::vector<int> all;
    for (const Chunk& chunk : chunks) all.insert(all.end(), chunk.begin(), chunk.end());
    return all;
}

void expect_plan(const std::vector<int>& frames, const Cut& cut) {
    SCOPED_TRACE(testing::Message() << frames.size() << " frames, at most " << cut.size << ", "
                                    << cut.workers << " workers, at most " << cut.most);
    const auto plan = chunks(frames, cut);
    EXPECT_EQ(joined(plan), frames);
    if (frames.empty()) return;
    const auto [least, greatest] =
        std::ranges::minmax(plan, {}, [](const Chunk& chunk) { return chunk.size(); });
    EXPECT_GE(least.size(), 1u);
    EXPECT_LE(greatest.size(), least.size() + 1);
    EXPECT_LE(plan.size(), cut.most);
    if (plan.size() == cut.most || plan.size() == frames.size()) return;
    EXPECT_LE(greatest.size(), cut.size);
    EXPECT_EQ(plan.size() % std::max<std::size_t>(cut.workers, 1), 0u);
}

TEST(Chunks, CoverAnySequenceInItsOrder) {
    for (const int frames : {0, 1, 2, 19, 20, 21, 40, 41}) {
        expect_plan(counted(frames), {});
        expect_plan(counted(frames), {.size = 1});
        expect_plan(counted(frames), {.size = 20, .workers = 64});
        expect_plan(counted(frames), {.size = 1, .most = 3});
    }
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto up_to = [&](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most)(random);
    };
    for (int k = 0; k < 500; ++k) {
        std::vector<int> frames = counted(int(up_to(300)));
        std::ranges::shuffle(frames, random);
        expect_plan(frames, {.size = 1 + up_to(40), .workers = up_to(9), .most = 1 + up_to(100)});
    }
}

TEST(Chunks, OfUnknownWorkersAreAsLargeAsTheyMayBe) {
    EXPECT_EQ(chunks(counted(120), {.size = 20}).size(), 6u);
    EXPECT_EQ(chunks(counted(121), {.size = 20}).size(), 7u);
}

// What workers are told is text, in which a chunk's own order is of no account.
TEST(Chunks, RangesAreReadBackAsTheSameFrames) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int k = 0; k < 200; ++k) {
        std::vector<int> frames = counted(60);
        std::erase_if(frames, [&](int) { return random() % 7 == 0; });
        if (k % 2) std::ranges::reverse(frames);
        if (k % 3 == 0) std::ranges::shuffle(frames, random);
        std::vector<int> read;
        for (const Chunk& chunk : chunks(frames, {.size = 9})) {
            const auto some = animation::parse_frame_range(animation::frame_range(chunk));
            read.insert(read.end(), some.begin(), some.end());
        }
        EXPECT_THAT(read, testing::UnorderedElementsAreArray(frames));
    }
}

} // namespace
} // namespace isomotion::farm
