#include "image/frame.h"

#include <gtest/gtest.h>

namespace isomotion::image {
namespace {

TEST(Metadata, IsFoundByName) {
    const Metadata metadata{{"frame", 812}, {"title", "Twist"}};
    ASSERT_NE(find(metadata, "frame"), nullptr);
    EXPECT_EQ(*find(metadata, "frame"), Value(812));
    EXPECT_EQ(*find(metadata, "title"), Value("Twist"));
    EXPECT_EQ(find(metadata, "time"), nullptr);
}

TEST(Metadata, TextIsShortestAndExact) {
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(1.0 / 3.0), "0.3333333333333333");
    EXPECT_EQ(to_text(-7), "-7");
    EXPECT_EQ(to_text(Rational{30000, 1001}), "30000/1001");
    EXPECT_EQ(to_text(std::vector{0.1, 2.0, -1e-300}), "[0.1, 2, -1e-300]");
    EXPECT_EQ(to_text(std::vector<double>{}), "[]");
}

TEST(Frame, FindsChannels) {
    const Frame frame{1, 1, {{"R", {0.5f}}, {"Z", {2.0f}}}, {}};
    ASSERT_NE(frame.find("Z"), nullptr);
    EXPECT_EQ(frame.find("Z")->samples[0], 2.0f);
    EXPECT_EQ(frame.find("A"), nullptr);
}

TEST(Frame, CheckRefusesWhatCannotBeAPicture) {
    EXPECT_NO_THROW(check({1, 2, {{"R", {0, 0}}}, {}}));
    EXPECT_THROW(check({0, 2, {{"R", {}}}, {}}), ImageError);
    EXPECT_THROW(check({1, -2, {{"R", {}}}, {}}), ImageError);
    EXPECT_THROW(check({1, 1, {}, {}}), ImageError);
    EXPECT_THROW(check({1, 1, {{"", {0}}}, {}}), ImageError);
    EXPECT_THROW(check({1, 1, {{"R", {0}}, {"R", {0}}}, {}}), ImageError);
    EXPECT_THROW(check({2, 1, {{"R", {0}}}, {}}), ImageError);
}

TEST(Frame, AreaDoesNotOverflow) {
    // 2^32 pixels are 0 in 32 bits, which would make this frame look right.
    EXPECT_THROW(check({65536, 65536, {{"R", {}}}, {}}), ImageError);
}

} // namespace
} // namespace isomotion::image
