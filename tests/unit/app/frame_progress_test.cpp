#include "app/frame_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isomotion::app {
namespace {

using testing::HasSubstr;
using testing::Optional;

std::optional<std::string> message(int frame, double passed, double part,
                                   std::optional<double> left = std::nullopt) {
    return long_frame({.frame = frame, .part = part, .seconds = passed, .left = left}, "size");
}

TEST(LongFrame, IsNotSpokenOfAtOnce) {
    EXPECT_EQ(message(1, 1.9, 0), std::nullopt);
    EXPECT_EQ(message(1, 1.9, 0.1, 1e6), std::nullopt);
}

TEST(LongFrame, IsOneOfOverTenSeconds) {
    EXPECT_EQ(message(1, 5, 0.51, 4.9), std::nullopt);
    EXPECT_THAT(message(7, 3, 0.25, 9), Optional(HasSubstr("frame 7 takes some 12 s: 25 % are")));
    EXPECT_THAT(message(7, 30, 0.05, 570), Optional(HasSubstr("some 10 minutes: 5 % are")));
    EXPECT_THAT(message(7, 36, 1e-3, 36e3), Optional(HasSubstr("some 10 hours")));
    EXPECT_THAT(message(7, 36, 1e-3, 36e3), Optional(HasSubstr("what costs: size")));
}

TEST(LongFrame, HasNoEstimateBeforeItsThirdPart) {
    EXPECT_EQ(message(3, 9, 0), std::nullopt);
    EXPECT_THAT(message(3, 11, 0), Optional(HasSubstr("nothing of it is drawn")));
    EXPECT_THAT(message(3, 11, 0.06), Optional(HasSubstr("6 % of it is drawn")));
    EXPECT_EQ(message(3, 11, 1), std::nullopt);
}

} // namespace
} // namespace isomotion::app
