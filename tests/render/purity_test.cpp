// A frame depends on its number and on nothing else: not on the frames before it, nor on how the
// picture is cut into tiles and passes.
#include "render/drawing.h"

#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

class Purity : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Purity);

TEST_P(Purity, TilesAndPassesChangeNoBit) {
    for (const char* method : {"marching", "amp-sign", "amp-taylor"}) {
        SCOPED_TRACE(method);
        const scene::Scene scene =
            scene::load("blobby75", {"look=none", "output.size=[70,50]",
                                     std::string("isolation.method=\"") + method + "\""});
        const Picture whole = draw(*context, scene, 31);
        for (const MarchPlan plan :
             {MarchPlan{70, 50, 1}, MarchPlan{70, 50, 7}, MarchPlan{16, 16, 700},
              MarchPlan{33, 17, 3}, MarchPlan{64, 64, 50}}) {
            const Picture cut = draw(*context, scene, 31, plan);
            EXPECT_TRUE(same_bits(whole.frame, cut.frame))
                << plan.tile_width << "x" << plan.tile_height << ", " << plan.evaluations_per_pass;
            EXPECT_EQ(whole.evaluations(), cut.evaluations());
        }
    }
}

TEST_P(Purity, FramesDoNotDependOnWhatWasDrawnBefore) {
    const scene::Scene scene =
        scene::load("twisting_superquadric", {"look=none", "output.size=[64,64]"});
    Renderer renderer(*context, scene, {64, 64, every_channel, {}});
    const auto frame = [&](int number) {
        return renderer.draw(scene::at_frame(scene, number)).frame;
    };
    const image::Frame alone = frame(57);
    for (const int number : {1, 120, 56}) frame(number);
    EXPECT_TRUE(same_bits(alone, frame(57)));
    EXPECT_TRUE(same_bits(alone, draw(*context, scene, 57).frame)) << "and of a fresh renderer";
    EXPECT_FALSE(same_bits(alone, frame(58)));
}

// Blocks that hold the background are not drawn again: the surface leaves some, moves to others,
// vanishes, and comes back.
TEST_P(Purity, WhatTheSurfaceLeavesIsBackgroundAgain) {
    const std::string motion = R"toml(
[surface.bounds]
box = [[-3, -1, -2], [3, 1, 2]]
[parameters]
a = "2*sin(1.7*t)"
r = "0.7*sin(2.3*t)"
[camera]
position = [0, -7, 1]
[time]
frames = 40
fps = 8
[output]
background = [0.3, 0.1, 0.2]
size = [104, 80]
)toml";
    for (const char* method : {"amp-sign", "hermite"}) {
        for (const char* formula :
             {"(x - a)^2 + y^2 + (z - a/3)^2 - r",
              "exp(-4*((x - a)^2 + y^2 + (z - a/3)^2)) + exp(-9*(x^2 + y^2 + z^2)) - 1.9 + r"}) {
            SCOPED_TRACE(std::string(method) + ", " + formula);
            const std::string text = "[surface]\nformula = '" + std::string(formula) +
                                     "'\n[isolation]\nmethod = '" + method + "'\n" + motion;
            const scene::Scene scene = scene_of(text);
            for (const auto& plan :
                 {std::optional<MarchPlan>(), std::optional(MarchPlan{64, 64, 2000})}) {
                Renderer renderer(*context, scene, {104, 80, every_channel, plan});
                for (int number = 1; number <= 40; number += 3) {
                    SCOPED_TRACE(number);
                    const scene::SceneAt now = scene::at_frame(scene, number);
                    const Picture after = renderer.draw(now);
                    const Picture alone = draw(*context, scene, number, plan);
                    EXPECT_TRUE(same_bits(after.frame, alone.frame));
                    EXPECT_EQ(after.evaluations(), alone.evaluations());
                    EXPECT_EQ(after.verdicts, alone.verdicts);
                }
            }
        }
    }
}

TEST_P(Purity, TwoRenderersTakeTurns) {
    const scene::Scene a =
        scene::load("twisting_superquadric", {"look=none", "output.size=[48,48]"});
    const scene::Scene b = scene::load("blobby75", {"look=none", "output.size=[48,32]"});
    const image::Frame only_a = draw(*context, a, 20).frame, only_b = draw(*context, b, 20).frame;
    Renderer first(*context, a, {48, 48, every_channel, {}});
    Renderer second(*context, b, {48, 32, every_channel, {}});
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_TRUE(same_bits(only_a, first.draw(scene::at_frame(a, 20)).frame));
        EXPECT_TRUE(same_bits(only_b, second.draw(scene::at_frame(b, 20)).frame));
    }
}

TEST_P(Purity, FingerprintsTellPicturesApart) {
    const scene::Scene scene =
        scene::load("twisting_superquadric", {"look=none", "output.size=[16,16]"});
    const auto print = [&](const scene::Scene& s, int frame) {
        return Renderer(*context, s, {s.output.width, s.output.height, {}, {}})
            .prepare(s, frame)
            .fingerprint;
    };
    const std::string base = print(scene, 10);
    EXPECT_EQ(base, print(scene, 10));
    EXPECT_NE(base, print(scene, 11));
    for (const char* change : {"m=2", "camera.fov=30", "material.color=[1,0,0]",
                               "output.size=[16,17]", "isolation.safety=9", "isolation.beam=true",
                               "isolation.method=\"marching\"", "output.background=[0,0,0]"}) {
        const scene::Scene changed =
            scene::load("twisting_superquadric", {"look=none", "output.size=[16,16]", change});
        EXPECT_NE(base, print(changed, 10)) << change;
    }
}

} // namespace
} // namespace isomotion::render
