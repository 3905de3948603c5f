// A frame is a function of its number: alone, in a sequence, backwards and again it is the same.
#include "cli.h"

namespace isomotion::cli {
namespace {

class Purity : public Cli, public testing::WithParamInterface<Words> {
protected:
    // The gallery's superquadric: parameters that move, powers, a light.
    void render_frames(const std::string& frames, const std::string& name) const {
        Words words{"twisting_superquadric", "--size", "48x48", "--frames", frames};
        words.insert(words.end(), {"-o", name + ".####" + GetParam().front()});
        words.insert(words.end(), GetParam().begin() + 1, GetParam().end());
        render(words);
    }
    std::string frame(const std::string& name, int number) const {
        return bytes(name + ".00" + std::to_string(number) + GetParam().front());
    }
};

TEST_P(Purity, AFrameAloneIsThatOfItsSequence) {
    render_frames("50-60", "forward");
    render_frames("57", "alone");
    EXPECT_EQ(frame("alone", 57), frame("forward", 57));
    EXPECT_NE(frame("forward", 56), frame("forward", 57));
}

TEST_P(Purity, TheOrderOfFramesDoesNotMatter) {
    render_frames("50-60", "forward");
    render_frames("60-50", "back");
    render_frames("57,50-60x3,51", "mixed");
    for (int number = 50; number <= 60; ++number) {
        EXPECT_EQ(frame("back", number), frame("forward", number)) << number;
    }
    for (const int number : {50, 51, 53, 56, 57, 59}) {
        EXPECT_EQ(frame("mixed", number), frame("forward", number)) << number;
    }
}

TEST_P(Purity, RenderingTwiceGivesTheSameBytes) {
    render_frames("57-59", "first");
    render_frames("57-59", "second");
    for (const int number : {57, 58, 59})
        EXPECT_EQ(frame("first", number), frame("second", number));
}

INSTANTIATE_TEST_SUITE_P(Formats, Purity,
                         testing::Values(Words{".png"},
                                         Words{".exr", "--channels", "z,n,p,verdict,evaluations"}),
                         [](const auto& instance) { return instance.param.front().substr(1); });

} // namespace
} // namespace isomotion::cli
