#include "app/time_amount.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace isomotion::app {
namespace {

double seconds(const char* text, double frames_per_second = 10) {
    return parse_time_amount("--dt", text).seconds(frames_per_second);
}

TEST(TimeAmount, IsInSecondsOrFrames) {
    EXPECT_EQ(seconds("1e-9"), 1e-9);
    EXPECT_EQ(seconds("0.25 s"), 0.25);
    EXPECT_DOUBLE_EQ(seconds("2 frames"), 0.2);
    EXPECT_DOUBLE_EQ(seconds("0.5frame", 30000.0 / 1001), 0.5 * 1001 / 30000);
    for (const char* wrong :
         {"", "-1", "nan", "inf", "1e999", "frames", "1 fps", "1 s s", "-1 frame"})
        EXPECT_THROW(seconds(wrong), std::invalid_argument) << wrong;
}

} // namespace
} // namespace isomotion::app
