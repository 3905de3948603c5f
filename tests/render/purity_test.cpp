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
            EXPECT_EQ(whole.evaluations, cut.evaluations);
        }
    }
}

TEST_P(Purity, FramesDoNotDependOnWhatWasDrawnBefore) {
    const scene::Scene scene =
        scene::load("twisting_superquadric", {"look=none", "output.size=[64,64]"});
    Renderer renderer(*context, scene, {64, 64, every_channel, {}});
    const auto frame = [&](int number) {
        return renderer.draw(scene::at(scene, scene.timeline.values(number))).frame;
    };
    const image::Frame alone = frame(57);
    for (const int number : {1, 120, 56}) frame(number);
    EXPECT_TRUE(same_bits(alone, frame(57)));
    EXPECT_TRUE(same_bits(alone, draw(*context, scene, 57).frame)) << "and of a fresh renderer";
    EXPECT_FALSE(same_bits(alone, frame(58)));
}

TEST_P(Purity, TwoRenderersTakeTurns) {
    const scene::Scene a =
        scene::load("twisting_superquadric", {"look=none", "output.size=[48,48]"});
    const scene::Scene b = scene::load("blobby75", {"look=none", "output.size=[48,32]"});
    const image::Frame only_a = draw(*context, a, 20).frame, only_b = draw(*context, b, 20).frame;
    Renderer first(*context, a, {48, 48, every_channel, {}});
    Renderer second(*context, b, {48, 32, every_channel, {}});
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_TRUE(same_bits(only_a, first.draw(scene::at(a, a.timeline.values(20))).frame));
        EXPECT_TRUE(same_bits(only_b, second.draw(scene::at(b, b.timeline.values(20))).frame));
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
