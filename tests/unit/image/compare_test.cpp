#include "unit/image/compare.h"

#include <limits>

#include <gtest/gtest.h>

namespace isomotion::image::compare_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Frame row(std::vector<float> samples) {
    const int width = int(samples.size());
    return {width, 1, {{"Z", std::move(samples)}}, {}};
}

TEST(Compare, EqualFramesAreWithinNoTolerance) {
    const Frame frame = row({0, 1, -2, nan, infinity, -infinity});
    const Comparison result = compare(frame, frame);
    EXPECT_TRUE(result.within_tolerance());
    ASSERT_EQ(result.channels.size(), 1u);
    EXPECT_EQ(result.channels[0].largest, 0);
    EXPECT_EQ(result.channels[0].mean, 0);
}

TEST(Compare, MeasuresEachChannel) {
    const Comparison result = compare(row({0, 1, 2, 3}), row({0, 1.5f, 2.25f, 3}), 0.3);
    ASSERT_EQ(result.channels.size(), 1u);
    EXPECT_EQ(result.channels[0].name, "Z");
    EXPECT_EQ(result.channels[0].largest, 0.5);
    EXPECT_EQ(result.channels[0].mean, 0.1875);
    EXPECT_EQ(result.channels[0].over_tolerance, 1u);
    EXPECT_FALSE(result.within_tolerance());
    EXPECT_TRUE(compare(row({0, 1, 2, 3}), row({0, 1.5f, 2.25f, 3}), 0.5).within_tolerance());
}

TEST(Compare, NothingToleratesNanOrInfinityAgainstANumber) {
    for (const auto& [a, b] : {std::pair{nan, 1.0f},
                               {1.0f, nan},
                               {infinity, 1.0f},
                               {infinity, -infinity},
                               {nan, infinity}}) {
        const Comparison result = compare(row({a, 0, 2}), row({b, 0, 1}), 1e30);
        EXPECT_FALSE(result.within_tolerance()) << a << " and " << b;
        EXPECT_EQ(result.channels[0].not_finite, 1u);
        EXPECT_EQ(result.channels[0].over_tolerance, 1u);
        EXPECT_EQ(result.channels[0].largest, double(infinity));
        EXPECT_EQ(result.channels[0].mean, 0.5);
    }
}

TEST(Compare, SizesMustAgree) {
    const Comparison result = compare(row({1, 2}), row({1}), 10);
    EXPECT_FALSE(result.same_size);
    EXPECT_TRUE(result.channels.empty());
    EXPECT_FALSE(result.within_tolerance());
}

TEST(Compare, ChannelsMustAgreeButNotTheirOrder) {
    const Frame first{1, 1, {{"R", {1}}, {"Z", {2}}}, {}};
    const Frame second{1, 1, {{"Z", {2}}, {"R", {1}}}, {}};
    EXPECT_TRUE(compare(first, second).within_tolerance());

    const Frame third{1, 1, {{"R", {1}}, {"A", {1}}}, {}};
    const Comparison result = compare(first, third);
    EXPECT_EQ(result.only_in_first, std::vector<std::string>{"Z"});
    EXPECT_EQ(result.only_in_second, std::vector<std::string>{"A"});
    EXPECT_FALSE(result.within_tolerance());
}

} // namespace
} // namespace isomotion::image::compare_test
