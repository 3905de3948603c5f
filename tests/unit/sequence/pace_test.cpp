#include "sequence/pace.h"

#include <gtest/gtest.h>

namespace isomotion::sequence {
namespace {

using Seconds = Pace::Seconds;

// The first two parts took longer, to compile.
TEST(Pace, IsThatOfLaterParts) {
    Pace pace;
    EXPECT_EQ(pace.left(Seconds(0)), std::nullopt);
    pace.note(0, Seconds(5));
    pace.note(0.25, Seconds(10));
    pace.note(0.5, Seconds(14));
    EXPECT_EQ(pace.left(Seconds(14)), std::nullopt);
    pace.note(0.75, Seconds(15));
    ASSERT_TRUE(pace.left(Seconds(15)));
    EXPECT_NEAR(pace.left(Seconds(15))->count(), 1, 1e-9);
    EXPECT_NEAR(pace.left(Seconds(15.5))->count(), 0.5, 1e-9);
    EXPECT_EQ(pace.left(Seconds(99))->count(), 0);
    pace.note(1, Seconds(17));
    EXPECT_NEAR(pace.left(Seconds(17))->count(), 0, 1e-9);
}

} // namespace
} // namespace isomotion::sequence
