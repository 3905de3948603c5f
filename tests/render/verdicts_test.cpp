// A pixel never lies silently.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "thorough.h"

namespace isomotion::render {
namespace {

using Texts = std::vector<std::string>;
// The methods that find every root.
const Texts finding{"hermite", "affine", "interval", "sphere"};

class Verdicts : public Drawing {
protected:
    Picture draw_formula(const std::string& formula, const std::string& rest = "") {
        return draw(*context,
                    scene_of("[surface]\nformula = \"" + formula +
                             "\"\nbounds = { sphere = 1.5 }\n[camera]\nposition = [5, 1, 1]\n"
                             "[output]\nsize = [48, 48]\n" +
                             rest));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Verdicts);

TEST_P(Verdicts, EveryPixelHasOneAndTheChannelAgreesWithTheCount) {
    const Picture picture = draw_formula("x^2 + y^2 + z^2 - 1");
    std::array<std::int64_t, 5> counted{};
    for (const float v : picture.frame.find("verdict")->samples) ++counted[std::size_t(v)];
    EXPECT_EQ(counted, picture.verdicts);
    double evaluations = 0;
    for (const float e : picture.frame.find("evaluations")->samples) evaluations += e;
    EXPECT_EQ(evaluations, double(picture.evaluations()));
}

TEST_P(Verdicts, NaNIsReportedAndPaintedMagenta) {
    // x < 2 everywhere in the bounds. The paper's methods stop there.
    const Picture picture = draw_formula("log(x - 2) + y", "[isolation]\nmethod = \"amp-sign\"\n");
    const auto nan = count(picture, Verdict::nan);
    EXPECT_GT(nan, 500);
    EXPECT_EQ(nan + count(picture, Verdict::miss), 48 * 48); // rays beside the bounds miss
    const auto& verdict = picture.frame.find("verdict")->samples;
    for (std::size_t k = 0; k < verdict.size(); ++k) {
        if (verdict[k] != float(Verdict::nan)) continue;
        EXPECT_EQ(picture.frame.find("R")->samples[k], 1);
        EXPECT_EQ(picture.frame.find("G")->samples[k], 0);
        EXPECT_EQ(picture.frame.find("B")->samples[k], 1);
    }
}

// Half of the bounds has no value of a part of F, though min and max make numbers of it there. Rays
// pass it in pieces that grow, whichever side of the plane y = 0 they begin on.
TEST_P(Verdicts, WhatMinAndMaxMakeOfNoValueIsPassedInFewSteps) {
    const Texts formulas{"min(-0.5 - log(y), 3)", "min(3 + x, -0.5 - log(y))",
                         "max(-0.5 - log(y), 0.7 + x - log(y))", "max(y^0.3 - 0.8, x - 0.4)",
                         "min(x^2 + z^2 - 0.1, -0.5 - log(y))"};
    for (const auto& [formula, method] :
         pairs_of(formulas, Texts{"hermite", "interval", "affine"})) {
        SCOPED_TRACE(fmt::format("{}, {}", formula, method));
        const Picture picture =
            draw_formula(formula, fmt::format("[isolation]\nmethod = '{}'\n", method));
        EXPECT_EQ(count(picture, Verdict::step_limit), 0);
        EXPECT_EQ(count(picture, Verdict::nan), 0);
        EXPECT_GT(count(picture, Verdict::hit), 20);
        EXPECT_LT(double(picture.evaluations()), 60.0 * 48 * 48);
    }
}

// As at the first frame of a motion that begins with 0.
TEST_P(Verdicts, WhatAParameterOf0DividesIsPassedInFewSteps) {
    const Texts formulas{"z - floor(x)/s",       "z - exp(-(x^2 + y^2)/s)",
                         "z - sin(x/s)",         "abs(x/s)^3 + y^2 + z^2 - 1",
                         "max(x/s, y) + z",      "cos(x/s) + log(y) + z",
                         "z - tanh(x/(2*s))",    "sqrt(x^2 + y^2)/s - z",
                         "min(z + 0.2/s, x + y)"};
    for (const auto& [formula, method] :
         pairs_of(formulas, Texts{"hermite", "interval", "affine"})) {
        SCOPED_TRACE(fmt::format("{}, {}", formula, method));
        const std::string rest =
            fmt::format("[isolation]\nmethod = '{}'\n[parameters]\ns = ", method);
        const Picture picture = draw_formula(formula, rest + "0\n");
        EXPECT_EQ(count(picture, Verdict::miss), 48 * 48);
        EXPECT_LT(double(picture.evaluations()), 100.0 * 48 * 48);
        EXPECT_GT(count(draw_formula(formula, rest + "0.3\n"), Verdict::hit), 100);
    }
}

TEST_P(Verdicts, ARayThatGivesUpIsNoMiss) {
    const Picture picture =
        draw_formula("x^2 + y^2 + z^2 - 1e-4", "[isolation]\nmethod = 'amp-sign'\nlimit = 5\n");
    EXPECT_GT(count(picture, Verdict::step_limit), 500);
    EXPECT_EQ(count(picture, Verdict::hit), 0);
}

// A step below the spacing of floats would stand still for ever.
TEST_P(Verdicts, AStepTooSmallForFloatEndsInTheStepLimit) {
    const Picture picture =
        draw_formula("x^2 + y^2 + z^2 - 1", "[isolation]\nmethod = 'amp-sign'\nstep = 1e-12\n");
    EXPECT_GT(count(picture, Verdict::step_limit), 500);
    EXPECT_EQ(count(picture, Verdict::hit), 0);
}

TEST_P(Verdicts, ZeroGradientIsAHitWithAFiniteNormal) {
    // A jump: the sign changes where the slope is 0 on either side. Signs alone tell of it.
    const Picture picture = draw_formula("sign(x - 0.2)", "[isolation]\nmethod = \"amp-sign\"\n");
    EXPECT_GT(count(picture, Verdict::zero_gradient), 100);
    for (const char* name : {"N.X", "N.Y", "N.Z", "R", "G", "B"}) {
        for (const float v : picture.frame.find(name)->samples) ASSERT_TRUE(std::isfinite(v));
    }
}

// F is 0 nowhere: by default there is no surface.
TEST_P(Verdicts, JumpsPolesAndMissingValuesAreNoRoots) {
    const Texts formulas{"sign(x - 0.2)", "floor(3*x) + 0.5 + 0*y", "1/(x - 0.1)", "log(x - 2) + y",
                         "1/(x*y*z) + 1e-3*sign(z)"};
    for (const auto& [formula, method] : pairs_of(formulas, finding)) {
        const Picture picture = draw_formula(formula, "[isolation]\nmethod = \"" + method + "\"\n");
        EXPECT_EQ(count(picture, Verdict::miss), 48 * 48) << formula << " by " << method;
    }
}

// ... and a root behind one is found.
TEST_P(Verdicts, RootsBehindJumpsAndMissingValuesAreFound) {
    const Picture plain = draw_formula("x + 0.4*y - 0.1");
    EXPECT_GT(count(plain, Verdict::hit), 800);
    // Four of each: the quick suite tries another pairing than above.
    const Texts formulas{
        "(x + 0.4*y - 0.1)*(1 + log(0.8 - x)^2)", "x + 0.4*y - 0.1 + 0*log(0.7 - x)",
        "(x + 0.4*y - 0.1)*(2 + sign(x - 0.8))", "(x + 0.4*y - 0.1)*(1 + 1/(x - 0.9)^2)"};
    for (const auto& [formula, method] : pairs_of(formulas, finding)) {
        const Picture picture = draw_formula(formula, "[isolation]\nmethod = \"" + method + "\"\n");
        EXPECT_EQ(picture.verdicts, plain.verdicts) << formula << " by " << method;
    }
}

// For y < 0 the surface is x = 0.2 by a term whose slope is infinity minus infinity though its
// value is next to nothing: no normal may be made up there. For y > 0 it is the plane x + y = 0.2.
TEST_P(Verdicts, ANaNGradientIsAZeroGradient) {
    const std::string wild = "1e-30*(sin(b*sin(b*x)) - sin(b*sin(b*x + 1)))";
    std::string padding; // long formulas take their gradient elsewhere
    for (int k = 1; k <= 70; ++k)
        padding += fmt::format(" + 1e-12*(x + {0})*(y + z*{0})*(z - {0})", k);
    for (const std::string& more : {std::string(), padding}) {
        const Picture picture =
            draw_formula("x - 0.2 + max(y, " + wild + ")" + more, "[parameters]\nb = 1e30\n");
        EXPECT_EQ(count(picture, Verdict::nan), 0);
        EXPECT_GT(count(picture, Verdict::zero_gradient), 20);
        EXPECT_GT(count(picture, Verdict::hit), 20);
        for (const char* name : {"N.X", "N.Y", "N.Z", "R", "G", "B"}) {
            for (const float v : picture.frame.find(name)->samples) ASSERT_TRUE(std::isfinite(v));
        }
    }
}

// Formulas that are finite on paper, where float is not: no NaN, whatever the camera sees.
TEST_P(Verdicts, FormulasThatAreFiniteOnPaperNeverGiveNaN) {
    const Texts formulas{"exp(100*z)*cos(50*y) - cos(x)",
                         "abs(x)^0.3 + abs(y)^0.3 + abs(z)^0.3 - 1",
                         "abs(3*x)^200 + abs(3*y)^200 + abs(3*z)^200 - 1",
                         "(6*x)^200 - (6*y)^200 + z",
                         "chebyshev(50, 6*x) - chebyshev(50, 6*y) + chebyshev(51, 6*z)",
                         "1/(x^2+y^2+z^2) - 1.5",
                         "sqrt(x^2 + y^2) + z^2 - 0.5",
                         "cosh(99*x) - cosh(99*y) + sinh(99*z)",
                         "pow(abs(x), 0.01) - pow(abs(y), 80) + pow(abs(z), -0.5) - 1",
                         "tan(20*x)*cos(20*x) - y"};
    for (const auto& [formula, method] : pairs_of(formulas, Texts{"amp-sign", "amp-taylor"})) {
        const Picture picture = draw_formula(formula, "[isolation]\nmethod = \"" + method + "\"\n");
        EXPECT_EQ(count(picture, Verdict::nan), 0) << formula << " by " << method;
        for (const float r : picture.frame.find("R")->samples)
            ASSERT_TRUE(std::isfinite(r)) << formula;
    }
}

} // namespace
} // namespace isomotion::render
