#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace isomotion::base {
namespace {

TEST(NearestName, FindsSlipsOfTheFinger) {
    const std::vector<std::string> names{"threshold", "sharpness", "weight", "sqrt"};
    EXPECT_EQ(nearest_name("treshold", names), "threshold");
    EXPECT_EQ(nearest_name("threshhold", names), "threshold");
    EXPECT_EQ(nearest_name("Sharpness", names), "sharpness");
    EXPECT_EQ(nearest_name("wieght", names), "weight");
    EXPECT_EQ(nearest_name("twsit", {"threshold", "twist"}), "twist");
    EXPECT_EQ(nearest_name("sqr", names), "sqrt");
    EXPECT_EQ(nearest_name("sqrtt", names), "sqrt");
    EXPECT_EQ(nearest_name("weight", names), "weight");
    EXPECT_EQ(nearest_name("X", {"y", "x"}), "x");
}

TEST(NearestName, SuggestsNothingFarFetched) {
    const std::vector<std::string> names{"threshold", "sharpness", "weight", "x", "m"};
    EXPECT_EQ(nearest_name("camera", names), "");
    EXPECT_EQ(nearest_name("q", names), "");
    EXPECT_EQ(nearest_name("wt", names), "");
    EXPECT_EQ(nearest_name("anything", {}), "");
}

TEST(NearestName, TheNearestAndOfEqualOnesTheFirst) {
    EXPECT_EQ(nearest_name("speed1", {"speed22", "speed2", "speed3"}), "speed2");
    EXPECT_EQ(nearest_name("speed", {"spend", "speed"}), "speed");
    EXPECT_EQ(nearest_name("mm", {"m"}), "m");
}

} // namespace
} // namespace isomotion::base
