#include "animation/timeline.h"

#include <cmath>

#include "animation/animation.h"
#include "testing.h"

namespace isomotion::animation {
namespace {

constexpr std::int64_t last_frame = 10'000'000;

TEST(Timeline, StartsAtZeroAndCountsFramesFromOne) {
    const Timeline timeline{{30, 1}, 120, {}};
    EXPECT_EQ(timeline.time(1), 0);
    EXPECT_EQ(timeline.time(2), 1.0 / 30);
    EXPECT_EQ(timeline.time(31), 1);
    EXPECT_EQ(timeline.time(61), 2);
}

// No drift: after `numerator` frames exactly `denominator` seconds have gone by, however often.
TEST(Timeline, MeetsWholeSecondsExactly) {
    for (const FrameRate fps : {FrameRate{24, 1}, FrameRate{30000, 1001}, FrameRate{24000, 1001},
                                FrameRate{2997, 125}, FrameRate{1, 7}, FrameRate{999'999'937, 3}}) {
        for (std::int64_t rounds = 0; rounds * fps.numerator < last_frame; ++rounds) {
            const std::int64_t frame = rounds * fps.numerator + 1;
            ASSERT_EQ(Timeline({fps, 1, {}}).time(frame), double(rounds * fps.denominator))
                << to_string(fps) << " at frame " << frame;
        }
    }
}

// The fused multiply-add leaves the exact error of the quotient: at most half an ulp of it.
TEST(Timeline, IsTheNearestDoubleAtAnyFrame) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const FrameRate fps{1 + random.below(120'000), 1 + random.below(2000)};
        const std::int64_t frame = 2 + random.below(last_frame - 1);
        const double time = Timeline({fps, 1, {}}).time(frame);
        const double error =
            std::fma(time, double(fps.numerator), -double((frame - 1) * fps.denominator));
        const double ulp = std::nextafter(time, INFINITY) - time;
        EXPECT_LE(std::abs(error), 0.5 * ulp * double(fps.numerator)) << to_string(fps);
    }
}

TEST(Timeline, AscendsFromFrameToFrame) {
    const Timeline timeline{{120'000, 1001}, 1, {}};
    for (std::int64_t frame = last_frame - 10'000; frame < last_frame; ++frame) {
        ASSERT_LT(timeline.time(frame), timeline.time(frame + 1)) << frame;
    }
}

TEST(Timeline, DoesNotOverflowAtTheSlowestRateThereIs) {
    const Timeline timeline{{1, 1'000'000'000}};
    EXPECT_EQ(timeline.time(last_frame + 1), 1e16);
    EXPECT_EQ(timeline.time((std::int64_t(1) << 31) - 1), 2147483646e9);
}

TEST(Timeline, ValuesAreTheAnimationsAtTheFramesTime) {
    const Timeline timeline{{30000, 1001}, 100};
    const Animation animation({track("m", "2*t")}, {});
    for (const int frame : {1, 2, 57, 100, 5000}) {
        const Values values = animation.at(timeline.time(frame));
        EXPECT_EQ(values.time, timeline.time(frame));
        EXPECT_EQ(values.tracks.at(0), 2 * timeline.time(frame));
    }
}

} // namespace
} // namespace isomotion::animation
