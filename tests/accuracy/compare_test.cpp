// How pixels are judged, on pictures and truths made by hand.
#include "accuracy/compare.h"

#include "accuracy/popping.h"
#include "render/drawing.h"

namespace isomotion::accuracy {
namespace {

using render::Verdict;
using roots::Answer;

// One pixel that looks along -x from (5, 0, 0) at a sphere of radius 1: its ray's t is 0 at the
// sphere's middle and runs along -x; a pixel is 4 wide.
constexpr const char* one_pixel = R"(
[surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 0.1
[output]
size = [1, 1]
)";

struct Pixel {
    Verdict verdict = Verdict::miss;
    double x = 1;        // of the hit
    double normal_z = 0; // of a normal along x, tilted
    std::optional<render::Proof> proof{};
};

Errors judged(const Pixel& pixel, const roots::FirstRoot& root) {
    const scene::Scene scene = render::scene_of(one_pixel);
    const scene::SceneAt now = scene::at_frame(scene, 1);
    image::Frame frame;
    frame.width = frame.height = 1;
    const auto add = [&](const char* name, double value) {
        frame.channels.push_back({name, {float(value)}});
    };
    add("verdict", double(pixel.verdict));
    add("P.X", pixel.x);
    add("P.Y", 0);
    add("P.Z", 0);
    add("N.X", 1);
    add("N.Y", 0);
    add("N.Z", pixel.normal_z);
    if (pixel.proof) add("proof", double(*pixel.proof));
    return compare(now, frame, {1, 1, {root}, 0});
}

roots::FirstRoot hit_at(double t) {
    return {Answer::hit, false, float(t), float(t), 0, 0, {1, 0, 0}};
}
const roots::FirstRoot miss{};
const roots::FirstRoot unknown{Answer::undecided, false, 0, 0, 0, 0, {}};

TEST(Compare, AProofIsOfWhatIsDrawnAndCertain) {
    using render::Proof;
    const auto contradicted = [](Verdict drawn, Proof proof, const roots::FirstRoot& root) {
        return judged({drawn, 1, 0, proof}, root).contradicted;
    };
    EXPECT_EQ(contradicted(Verdict::hit, Proof::hit, hit_at(-1)), 0);
    EXPECT_EQ(contradicted(Verdict::miss, Proof::miss, miss), 0);
    EXPECT_EQ(contradicted(Verdict::hit, Proof::miss, hit_at(-1)), 1);
    EXPECT_EQ(contradicted(Verdict::hit, Proof::miss, miss), 1);
    EXPECT_EQ(contradicted(Verdict::miss, Proof::hit, miss), 1);
    EXPECT_EQ(contradicted(Verdict::miss, Proof::miss, hit_at(-1)), 1);
    EXPECT_EQ(contradicted(Verdict::miss, Proof::miss, unknown), 0);
    EXPECT_EQ(contradicted(Verdict::hit, Proof::hit, hit_at(1)), 1) << "far from the root";
    for (const Proof open : {Proof::none, Proof::hidden, Proof::sign, Proof::budget}) {
        EXPECT_EQ(contradicted(Verdict::hit, open, miss), 0);
    }
}

TEST(Compare, AMissIsRightWhereNothingIs) {
    EXPECT_EQ(judged({Verdict::miss}, miss).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::miss}, hit_at(-1)).faults[0], Fault::missed);
    EXPECT_EQ(judged({Verdict::step_limit}, hit_at(-1)).faults[0], Fault::missed);
    EXPECT_EQ(judged({Verdict::nan}, hit_at(-1)).faults[0], Fault::missed);
}

TEST(Compare, AHitIsRightWithinAPixelOfTheFirstRoot) {
    // x = 1 is t = -1; the pixel is a tenth wide.
    EXPECT_EQ(judged({Verdict::hit, 1}, hit_at(-1)).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::zero_gradient, 1}, hit_at(-1)).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::hit, 0.91}, hit_at(-1)).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::hit, 0.89}, hit_at(-1)).faults[0], Fault::wrong_root);
    EXPECT_EQ(judged({Verdict::hit, -1}, hit_at(-1)).faults[0], Fault::wrong_root);
    EXPECT_EQ(judged({Verdict::hit, 1.09}, hit_at(-1)).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::hit, 1.11}, hit_at(-1)).faults[0], Fault::false_hit);
    EXPECT_EQ(judged({Verdict::hit, 1}, miss).faults[0], Fault::false_hit);
}

TEST(Compare, WhereSomethingTouchesBothAreRight) {
    const roots::FirstRoot touch_then_miss{Answer::touching, false, 0, 0, -1.01f, -0.99f, {}};
    const roots::FirstRoot touch_then_hit{Answer::touching, true, 0.5f, 0.5f, -1.01f, -0.99f, {}};
    EXPECT_EQ(judged({Verdict::hit, 1}, touch_then_miss).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::miss}, touch_then_miss).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::hit, 0}, touch_then_miss).faults[0], Fault::false_hit);
    EXPECT_EQ(judged({Verdict::hit, 1}, touch_then_hit).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::hit, -0.5}, touch_then_hit).faults[0], Fault::none);
    EXPECT_EQ(judged({Verdict::miss}, touch_then_hit).faults[0], Fault::missed);
    EXPECT_EQ(judged({Verdict::hit, -1}, touch_then_hit).faults[0], Fault::wrong_root);
}

TEST(Compare, WhatTruthDoesNotKnowIsNotWrong) {
    for (const Verdict verdict : {Verdict::miss, Verdict::hit, Verdict::nan}) {
        const Errors errors = judged({verdict}, unknown);
        EXPECT_EQ(errors.undecided, 1);
        EXPECT_EQ(errors.wrong(), 0);
    }
    EXPECT_EQ(judged({Verdict::nan}, unknown).nan, 1);
}

TEST(Compare, DepthIsInPixelsAndNormalsInDegrees) {
    const Errors errors = judged({Verdict::hit, 0.98, std::tan(M_PI / 6)}, hit_at(-1));
    ASSERT_EQ(errors.depth.size(), 1u);
    EXPECT_NEAR(errors.depth[0], 0.2, 1e-5);
    ASSERT_EQ(errors.normal.size(), 1u);
    EXPECT_NEAR(errors.normal[0], 30, 1e-4);
    // A pixel that is not right has neither.
    EXPECT_TRUE(judged({Verdict::hit, -1}, hit_at(-1)).depth.empty());
}

TEST(Compare, PicturesAddUp) {
    Errors sum = judged({Verdict::hit, 0.98}, hit_at(-1));
    sum.add(judged({Verdict::hit, 0.99}, hit_at(-1)));
    sum.add(judged({Verdict::miss}, hit_at(-1)));
    EXPECT_EQ(sum.pixels, 3);
    EXPECT_EQ(sum.rays, 3);
    EXPECT_EQ(sum.wrong(), 1);
    EXPECT_NEAR(sum.wrong_ppm(), 1e6 / 3, 1e-6);
    EXPECT_TRUE(std::is_sorted(sum.depth.begin(), sum.depth.end()));
    EXPECT_NEAR(quantile(sum.depth, 0), 0.1, 1e-5);
    EXPECT_NEAR(quantile(sum.depth, 1), 0.2, 1e-5);
    EXPECT_EQ(quantile({}, 0.5), 0);
}

// A row of pixels over frames: hits are letters, `truths` the same for what is certain.
std::int64_t pops(const std::vector<std::string>& drawn, const std::vector<std::string>& truths) {
    Popping popping;
    for (std::size_t frame = 0; frame < drawn.size(); ++frame) {
        image::Frame picture;
        roots::Truth truth;
        picture.channels.push_back({"verdict", {}});
        for (const char c : drawn[frame]) picture.channels[0].samples.push_back(c == 'h' ? 1 : 0);
        for (const char c : truths[frame]) {
            truth.roots.push_back(c == 'h' ? hit_at(0) : c == '?' ? unknown : miss);
        }
        popping.add(picture, truth);
    }
    return popping.count();
}

TEST(Popping, IsAFlipForOneFrameThatTruthDoesNotMake) {
    EXPECT_EQ(pops({"h", ".", "h"}, {"h", "h", "h"}), 1);
    EXPECT_EQ(pops({".", "h", "."}, {".", ".", "."}), 1);
    EXPECT_EQ(pops({"h", ".", "h"}, {"h", ".", "h"}), 0); // as truth does
    EXPECT_EQ(pops({"h", ".", "."}, {"h", "h", "h"}), 0); // for longer: wrong, but no popping
    EXPECT_EQ(pops({"h", ".", "h"}, {"h", "?", "h"}), 0);
    EXPECT_EQ(pops({"h", "."}, {"h", "h"}), 0);
    EXPECT_EQ(pops({"h", ".", "h", ".", "h"}, {"h", "h", "h", "h", "h"}), 3);
    EXPECT_EQ(pops({"hh", ".h", "hh"}, {"hh", "hh", "hh"}), 1);
}

} // namespace
} // namespace isomotion::accuracy
