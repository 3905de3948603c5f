// Methods that bound F over pieces of a ray: what they call free is free, and what they can't tell
// they say. Held against closed forms and certified truth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "accuracy/compare.h"
#include "accuracy/piled_blobs.h"
#include "render/drawing.h"
#include "roots/certify.h"

namespace isomotion::accuracy {
namespace {

using render::count, render::draw, render::Picture, render::piled_blobs, render::scene_of,
    render::Verdict;

constexpr const char* proving[] = {"interval", "affine", "sphere"};

std::string isolation(const char* method, const std::string& more = {}) {
    return fmt::format("[isolation]\nmethod = \"{}\"\n{}\n", method, more);
}

class Proofs : public render::Drawing {
protected:
    Picture draw_formula(const char* method, const std::string& formula,
                         const std::string& more = {}) {
        return draw(*context, scene_of("[surface]\nformula = \"" + formula +
                                       "\"\nbounds = { sphere = 1.5 }\n[camera]\nposition = "
                                       "[5, 1, 1]\n[output]\nsize = [48, 48]\n" +
                                       isolation(method, more)));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Proofs);

TEST_P(Proofs, ASphereIsWhereItIs) {
    for (const char* method : proving) {
        SCOPED_TRACE(method);
        const Picture picture = draw(*context, scene_of(R"(
[surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 2.4
[output]
size = [96, 96]
)" + isolation(method)));
        const double pixel = 2.4 / 96;
        int hits = 0, misses = 0;
        for (int row = 0; row < 96; ++row) {
            for (int column = 0; column < 96; ++column) {
                const auto at = [&](const char* name) {
                    return double(
                        picture.frame.find(name)->samples[std::size_t(row * 96 + column)]);
                };
                const double off = std::hypot(column - 47.5, row - 47.5) * pixel;
                const auto verdict = Verdict(int(at("verdict")));
                ASSERT_EQ(verdict, off < 1 ? Verdict::hit : Verdict::miss) << column << "," << row;
                if (off >= 1) ++misses;
                if (off >= 0.999) continue;
                ++hits;
                EXPECT_NEAR(at("P.X"), std::sqrt(1 - off * off), pixel / 512);
            }
        }
        EXPECT_GT(hits, 4000);
        EXPECT_GT(misses, 2000);
    }
}

// Two sheets a thousandth apart, thinner than any sampled step: both a closed form and what
// sampling misses.
TEST_P(Proofs, AThinShellIsNotSteppedOver) {
    for (const char* method : proving) {
        const Picture picture = draw_formula(method, "(x - 0.2)^2 - 1e-7");
        const Picture plane = draw_formula(method, "x - 0.2");
        EXPECT_GT(count(plane, Verdict::hit), 900) << method;
        EXPECT_NEAR(double(count(picture, Verdict::hit)), double(count(plane, Verdict::hit)), 4)
            << method;
    }
}

// A double root is one for every method that can't prove there is none.
TEST_P(Proofs, ADoubleRootIsFound) {
    for (const char* method : proving) {
        const Picture once = draw_formula(method, "x^2 + y^2 + z^2 - 1");
        const Picture twice = draw_formula(method, "(x^2 + y^2 + z^2 - 1)^2");
        EXPECT_GT(count(once, Verdict::hit), 500) << method;
        EXPECT_GE(count(twice, Verdict::hit) + count(twice, Verdict::zero_gradient),
                  count(once, Verdict::hit))
            << method;
    }
}

TEST_P(Proofs, GivingUpIsNoMissAndNoHit) {
    for (const char* method : proving) {
        SCOPED_TRACE(method);
        const Picture tired = draw_formula(method, "x^2 + y^2 + z^2 - 1e-4", "limit = 2");
        EXPECT_GT(count(tired, Verdict::step_limit), 500);
        EXPECT_EQ(count(tired, Verdict::hit), 0);
        // There is no root where F has no value, and none is missed behind such a place.
        const Picture undefined = draw_formula(method, "log(x - 2) + y");
        EXPECT_EQ(count(undefined, Verdict::miss), 48 * 48);
        const Picture pole = draw_formula(method, "1/(x - 0.2)");
        EXPECT_EQ(count(pole, Verdict::hit), 0);
    }
}

// Sums loop in both functions that a turn calls: 4001 terms are past the driver's limit of loop
// iterations after eight turns.
TEST_P(Proofs, LongSumsAreSummedToTheirEnd) {
    const std::string output = "[output]\nsize = [16, 16]\n";
    for (const char* method : proving) {
        SCOPED_TRACE(method);
        const Picture few =
            draw(*context, scene_of(piled_blobs(3, "1 + 0*i", output + isolation(method))));
        scene::Scene long_sum =
            scene_of(piled_blobs(4001, "max(0, min(1, i - (n - 4)))", output + isolation(method)));
        long_sum.surfaces[0].isolation.beam = false; // no elements by place
        const Picture many = draw(*context, long_sum);
        EXPECT_GT(count(few, Verdict::hit), 30);
        EXPECT_EQ(few.verdicts, many.verdicts);
        EXPECT_GT(many.passes, few.passes);
    }
}

// The surface hides and mirrors itself; the sign test draws the same.
TEST_P(Proofs, ShadowsAndMirrorsAreThoseOfTheSignTest) {
    const std::string scene = R"(
[surface]
use = "torus"
[material]
reflection = "self"
[[lights]]
direction = [2, 1, 1]
shadow = true
[output]
size = [64, 64]
)";
    const Picture expected = draw(*context, scene_of(scene + isolation("amp-sign")));
    for (const char* method : proving) {
        const Picture picture = draw(*context, scene_of(scene + isolation(method)));
        const auto &a = expected.frame.find("R")->samples, &b = picture.frame.find("R")->samples;
        int different = 0;
        for (std::size_t k = 0; k < a.size(); ++k) different += !(std::abs(a[k] - b[k]) < 0.02f);
        EXPECT_LE(different, 64 * 64 / 100) << method;
    }
}

class ProofsOfCatalogue : public testing::TestWithParam<std::string> {};

// Where float can't tell F from 0 in the shortest piece there is a hit: beside nodes and
// silhouettes, by less than a pixel's 8192nd part and what rounding makes of F.
TEST_P(ProofsOfCatalogue, MissNoCertainRoot) {
    const auto context = gpu::Context::create();
    const std::string text = "[surface]\nuse = \"" + GetParam() + "\"\n[output]\nsize = [96, 96]\n";
    const scene::Scene plain = scene_of(text);
    const scene::SceneAt now = scene::at_frame(plain, 1);
    const roots::Truth truth = roots::certify(plain, now, 96, 96);
    for (const char* method : proving) {
        SCOPED_TRACE(method);
        const Picture picture = draw(*context, scene_of(text + isolation(method)));
        const Errors errors = compare(now, picture.frame, truth);
        EXPECT_EQ(errors.missed, 0);
        EXPECT_EQ(errors.wrong_roots, 0);
        EXPECT_LE(errors.false_hits, method == std::string("interval") ? 2 : 0);
        EXPECT_EQ(errors.nan, 0);
        EXPECT_EQ(errors.step_limit, 0);
        EXPECT_GT(count(picture, Verdict::hit), 500);
    }
}
INSTANTIATE_TEST_SUITE_P(Surfaces, ProofsOfCatalogue,
                         testing::Values("torus", "cayley", "ding_dong", "barth_sextic", "blobby",
                                         "superquadric", "chmutov_14"),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace isomotion::accuracy
