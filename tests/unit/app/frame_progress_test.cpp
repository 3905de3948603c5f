#include "app/frame_progress.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isomotion::app {
namespace {

using testing::HasSubstr;
using testing::Optional;
using Seconds = std::chrono::duration<double>;

TEST(LongFrame, IsNotSpokenOfBeforeTenSeconds) {
    for (const double part : {0.0, 1e-9, 0.5, 1.0}) {
        EXPECT_EQ(long_frame(1, Seconds(9.9), part), std::nullopt) << part;
    }
}

TEST(LongFrame, IsOneOfOverAMinute) {
    EXPECT_EQ(long_frame(1, Seconds(30), 0.51), std::nullopt);
    EXPECT_THAT(long_frame(7, Seconds(30), 0.45), Optional(HasSubstr("frame 7 takes some 67 s")));
    EXPECT_THAT(long_frame(7, Seconds(30), 0.05), Optional(HasSubstr("some 10 minutes: 5 % are")));
    EXPECT_THAT(long_frame(7, Seconds(36), 1e-3), Optional(HasSubstr("some 10 hours")));
    EXPECT_EQ(long_frame(1, Seconds(1e6), std::numeric_limits<double>::infinity()), std::nullopt);
}

TEST(LongFrame, HasNoEstimateBeforeItsFirstTile) {
    EXPECT_EQ(long_frame(3, Seconds(59), 0), std::nullopt);
    EXPECT_THAT(long_frame(3, Seconds(61), 0), Optional(HasSubstr("nothing of it is drawn")));
}

} // namespace
} // namespace isomotion::app
