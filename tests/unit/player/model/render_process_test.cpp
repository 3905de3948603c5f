// Frames are told apart by their numbers alone, whatever a scene's file is called.
#include "player/model/render_process.h"

#include <gtest/gtest.h>

namespace isomotion::player {
namespace {

TEST(StemOfFrames, HasNoPlaceForANumber) {
    EXPECT_EQ(stem_of_frames("torus"), "torus");
    for (const std::string name : {"a#b", "%d", "50%04d", "##_#", "take %3d #2"}) {
        const std::string stem = stem_of_frames(name);
        EXPECT_EQ(stem.size(), name.size());
        const auto frames = sequence::SequenceName::parse("out/" + stem + ".####.png");
        EXPECT_EQ(frames.path(7), "out/" + stem + ".0007.png");
    }
}

} // namespace
} // namespace isomotion::player
