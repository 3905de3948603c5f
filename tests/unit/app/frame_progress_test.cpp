#include "app/frame_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/reading/load.h"

namespace isomotion::app {
namespace {

using testing::HasSubstr;
using testing::Optional;
using Seconds = std::chrono::duration<double>;

std::optional<std::string> message(int frame, double passed, double part,
                                   std::optional<double> left = std::nullopt) {
    return long_frame(frame, Seconds(passed), part,
                      left ? std::optional(Seconds(*left)) : std::nullopt, "size");
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

TEST(WhatCosts, IsWhatTheSceneAsksFor) {
    scene::Scene scene = scene::load_text("[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\n"
                                          "bounds = { sphere = 1.5 }\n"
                                          "[output]\nsize = [64, 48]\n",
                                          "costs.toml");
    EXPECT_EQ(what_costs(scene), "64x48 pixels (--size)");
    scene.output.samples = 16;
    scene.surfaces[0].material.glass.emplace().depth = 6;
    EXPECT_EQ(what_costs(scene), "16 samples a pixel (--set output.samples=1), glass 6 rays deep "
                                 "(material.glass.depth), 64x48 pixels (--size)");
}

} // namespace
} // namespace isomotion::app
