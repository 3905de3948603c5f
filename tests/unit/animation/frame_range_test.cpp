#include "animation/frame_range.h"

#include <algorithm>
#include <random>
#include <set>

#include "testing.h"

namespace isomotion::animation {
namespace {

using testing::HasSubstr;
using Frames = std::vector<int>;

TEST(FrameRange, Grammar) {
    const std::pair<const char*, Frames> cases[] = {
        {"5", {5}},
        {"1-4", {1, 2, 3, 4}},
        {"1-10x3", {1, 4, 7, 10}},
        {"1-9x3", {1, 4, 7}},
        {"1-2x100", {1}},
        {"7-7", {7}},
        {"7x3", {7}},
        {"4-1", {4, 3, 2, 1}},
        {"10-1x4", {10, 6, 2}},
        {"1,3,5-7", {1, 3, 5, 6, 7}},
        {"130,1-3", {130, 1, 2, 3}},
        {"0007", {7}},
        {"10000000", {10'000'000}},
    };
    for (const auto& [text, frames] : cases) EXPECT_EQ(parse_frame_range(text), frames) << text;
}

TEST(FrameRange, EachFrameOnceWhereItCameFirst) {
    EXPECT_EQ(parse_frame_range("3,1-5,2"), (Frames{3, 1, 2, 4, 5}));
    EXPECT_EQ(parse_frame_range("1-9x4,9-1x2"), (Frames{1, 5, 9, 7, 3}));
    EXPECT_EQ(parse_frame_range("2,2,2"), (Frames{2}));
}

TEST(FrameRange, StepsFromTheFirstTowardsTheLast) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const int first = 1 + random.below(500), last = 1 + random.below(500);
        const int step = 1 + random.below(40);
        const Frames frames = parse_frame_range(std::to_string(first) + "-" + std::to_string(last) +
                                                "x" + std::to_string(step));
        ASSERT_EQ(frames.size(), std::size_t(std::abs(last - first) / step + 1));
        for (std::size_t k = 0; k < frames.size(); ++k) {
            EXPECT_EQ(frames[k], first + (first <= last ? 1 : -1) * int(k) * step);
        }
    }
}

TEST(FrameRange, EndsAtTheLastFrameThereMayBe) {
    EXPECT_EQ(parse_frame_range("9999998-10000000").back(), 10'000'000);
    EXPECT_EQ(parse_frame_range("1-10000000x10000000"), (Frames{1}));
    EXPECT_EQ(parse_frame_range("10000000-1x10000000"), (Frames{10'000'000}));
}

std::string complaint_about(const std::string& text) {
    try {
        return "no complaint, " + std::to_string(parse_frame_range(text).size()) + " frames";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(FrameRange, SaysWhatIsNoRangeAndHowOneIsWritten) {
    for (const char* text : {"", "a", "1-", "-", "1-2-3", "1x", "1-10x", "x2", "-5", "1..5", "1:5",
                             "1-3x2x2", "1.5", "1 - 3", "+1", "0x5F", "5-x2"}) {
        const std::string complaint = complaint_about(text);
        EXPECT_THAT(complaint,
                    HasSubstr("'" + std::string(text) + "' is not a frame range: write"));
        EXPECT_THAT(complaint, HasSubstr("(1-10x2)"));
    }
    EXPECT_THAT(complaint_about("1-5,,7"), HasSubstr("'' is not a frame range"));
    EXPECT_THAT(complaint_about("1-5,"), HasSubstr("'' is not a frame range"));
    EXPECT_THAT(complaint_about(",1"), HasSubstr("'' is not a frame range"));
    EXPECT_THAT(complaint_about("1-5,b,9"), HasSubstr("'b' is not a frame range"));
}

TEST(FrameRange, SaysWhichNumbersFramesHave) {
    for (const char* text :
         {"0", "0-5", "5-0", "1-5x0", "10000001", "1-10000001", "1--5", "5x-1", "1-99999999999"}) {
        const std::string complaint = complaint_about(text);
        EXPECT_THAT(complaint, HasSubstr("'" + std::string(text) + "'"));
        EXPECT_THAT(complaint, HasSubstr("frames and steps count from 1 to 10000000"));
    }
    EXPECT_THAT(complaint_about("1-5,0,7"), HasSubstr("'0'"));
}

TEST(FrameRange, IsWrittenShortly) {
    const std::pair<Frames, const char*> cases[] = {
        {{}, ""},
        {{5}, "5"},
        {{4, 5}, "4-5"},
        {{3, 2, 1, 2}, "1-3"},
        {{1, 3}, "1,3"},
        {{1, 3, 5}, "1-5x2"},
        {{1, 2, 3, 7, 10, 13, 16, 18}, "1-3,7-16x3,18"},
        {{130, 1, 2, 3}, "1-3,130"},
    };
    for (const auto& [frames, text] : cases) EXPECT_EQ(frame_range(frames), text);
}

TEST(FrameRange, WhatIsWrittenIsReadAgain) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 300; ++round) {
        std::set<int> frames;
        const int most = 1 + int(random() % 60);
        while (frames.size() < std::size_t(1 + round % 30))
            frames.insert(1 + int(random() % 2000) % (most + 30));
        const Frames wanted(frames.begin(), frames.end());
        Frames read = parse_frame_range(frame_range(wanted));
        std::ranges::sort(read);
        EXPECT_EQ(read, wanted) << frame_range(wanted);
    }
}

} // namespace
} // namespace isomotion::animation
