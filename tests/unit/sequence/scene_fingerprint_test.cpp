#include "sequence/scene_fingerprint.h"

#include <set>

#include <gtest/gtest.h>

#include "scene/reading/load.h"

namespace isomotion::sequence {
namespace {

std::string print(const std::vector<scene::Override>& changes) {
    return scene_fingerprint(scene::load(ISOMOTION_SOURCE_DIR "/animations/torus.toml", changes));
}

TEST(SceneFingerprint, EveryChangeShows) {
    const std::vector<scene::Override> changes = {
        "camera.fov=31",
        "camera.up=[0,1,0]",
        "output.size=[40,40]",
        "output.samples=4",
        "output.background=\"transparent\"",
        "material.color=[1,0,0]",
        "material.model=\"ggx\"",
        "isolation.method=\"amp-sign\"",
        "isolation.step=0.0123",
        "isolation.certify=true",
        "isolation.limit=5000",
        "time.fps=12",
        "material.reflection=\"sky\"",
        "surface.placement.scale=1.5",
    };
    std::set<std::string> prints{print({})};
    for (const auto& change : changes) EXPECT_TRUE(prints.insert(print({change})).second) << change;
}

TEST(SceneFingerprint, IsTheSameEachTime) { EXPECT_EQ(print({}), print({})); }

// More frames of the same animation are the same scene.
TEST(SceneFingerprint, TheNumberOfFramesDoesNotCount) {
    EXPECT_EQ(print({"time.frames=7", "output.poster=1"}),
              print({"time.frames=9", "output.poster=2"}));
}

} // namespace
} // namespace isomotion::sequence
