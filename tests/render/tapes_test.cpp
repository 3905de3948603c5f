// Formulas that are run from tapes of their instructions are drawn as those that are compiled.
#include "render/drawing.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "shader/assemble.h"
#include "shader/inlined_size.h"
#include "shader/tape_text.h"

namespace isomotion::render::tapes_test {
namespace {

class Tapes : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Tapes);

// During its lifetime each formula is run.
class RunEach {
public:
    RunEach() { ::setenv("ISOMOTION_LARGEST_SHADERS", "1", 1); }
    ~RunEach() { ::unsetenv("ISOMOTION_LARGEST_SHADERS"); }
    RunEach(const RunEach&) = delete;
    RunEach& operator=(const RunEach&) = delete;
};

std::string scene_text(const std::string& formula, const std::string& more = "") {
    return fmt::format("surface.formula = \"{}\"\nsurface.bounds.sphere = 2\n"
                       "output.size = [48, 48]\n{}",
                       formula, more);
}

// Pixels that differ by their verdict, or by more than a thousandth in depth.
int unlike(const Picture& a, const Picture& b) {
    const auto& verdicts = a.frame.find("verdict")->samples;
    const auto& others = b.frame.find("verdict")->samples;
    const auto& depths = a.frame.find("Z")->samples;
    const auto& other_depths = b.frame.find("Z")->samples;
    int count = 0;
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        const bool far =
            std::isfinite(depths[k]) && !(std::abs(depths[k] - other_depths[k]) < 1e-3);
        count += verdicts[k] != others[k] || far;
    }
    return count;
}

void expect_alike(gpu::Context& context, const std::string& text, int frame = 1) {
    SCOPED_TRACE(text);
    const scene::Scene scene = scene_of(text);
    const Picture compiled = draw(context, scene, frame);
    const RunEach run;
    ASSERT_TRUE(shader::assemble(scene).tapes);
    const Picture by_tapes = draw(context, scene, frame);
    EXPECT_GT(count(compiled, Verdict::hit), 20);
    EXPECT_LE(unlike(compiled, by_tapes), 2);
    EXPECT_EQ(count(by_tapes, Verdict::nan), count(compiled, Verdict::nan));
}

TEST_P(Tapes, DrawWhatIsCompiled) {
    for (const char* formula : {
             "x^2 + y^2 + z^2 - 1",                                   // smooth
             "(x^2 + y^2 + z^2 + 0.6)^2 - 4*(x^2 + y^2)",             // two roots and more
             "max(max(abs(x), abs(y)), abs(z)) - 0.9",                // kinks
             "min(x^2 + y^2 - 0.1, max(abs(z), abs(x - 0.4)) - 0.5)", // bodies joined
             "exp(-x^2) + log(1.5 + y^2) - cos(2*z) - sin(x*y)",      // calls
             "abs(x)^1.5 + abs(y)^0.7 + abs(z)^2.5 - 1",              // powers
             "z - 0.2*floor(4*x)",                                    // jumps
             "1/(x^2 + 0.2) + y^2 + z^2 - 2",                         // quotients
             "chebyshev(6, x) + chebyshev(6, y) + chebyshev(6, z)",
             "sqrt(x^2 + y^2) - 1 + z*tanh(z)*atan(x/(2 + y))",
             "z - 0.2*atan2(y, x)",                                // a jump
             "z + min(noise(2*x, 2*y, z), 0.3*noise(y, 0.7, x)) + 0.1*exp(x)",
             "sqrt(x^2 + y^2) - 1 - 0.2*cos(5*atan2(y, x) + 3*z)", // an angle without one
         })
        expect_alike(*context, scene_text(formula));
}

TEST_P(Tapes, FollowParametersThatMove) {
    const std::string moving = "[parameters]\nr = \"0.5 + t/60\"\n[time]\nframes = 30\n"
                               "fps = 30\n";
    expect_alike(*context, scene_text("max(abs(x) - r, x^2 + y^2 + z^2 - 1.2*r)", moving), 1);
    expect_alike(*context, scene_text("max(abs(x) - r, x^2 + y^2 + z^2 - 1.2*r)", moving), 30);
}

TEST_P(Tapes, ShadowsMirrorsAndSectionsFollow) {
    const std::string body = "max(max(abs(x), abs(y)), abs(z)) - 0.7";
    expect_alike(*context, scene_text(body, "[occlusion]\nradius = 0.5\n"));
    expect_alike(*context, scene_text(body, "[[lights]]\ndirection = [1, 1, 2]\nshadow = true\n"));
    expect_alike(*context, scene_text(body, "material.reflection = \"self\"\n"));
    expect_alike(*context, scene_text(body, "[[sections]]\nnormal = [1, 0, 0]\noffset = 0.2\n"));
}

TEST_P(Tapes, OtherMethodsRunThem) {
    for (const char* method : {"marching", "amp-sign", "amp-taylor", "interval", "affine"}) {
        expect_alike(*context, scene_text("max(max(abs(x), abs(y)), abs(z)) - 0.7",
                                          fmt::format("isolation.method = \"{}\"\n", method)));
    }
}

TEST_P(Tapes, ProofsRunThem) {
    const scene::Scene scene = scene_of(
        scene_text("max(x^2 + y^2 + z^2 - 1, abs(x) - 0.5)", "isolation.certify = true\n"));
    const RunEach run;
    Renderer renderer(*context, scene, {48, 48, {shader::Channel::proof}});
    const Picture picture = renderer.draw(scene::at_frame(scene, 1));
    EXPECT_GT(proved_part(picture.proofs), 0.9) << summary(picture.proofs);
}

// 400 balls in rows, which take minutes to compile: each is met. No min has two of them as
// operands, since those would be an array's elements.
TEST_P(Tapes, LongFormulasAreDrawnAtOnce) {
    std::string formula = "m = 1; ";
    for (int k = 0; k < 400; ++k) {
        formula += fmt::format("m = 1.001*min(m, (x - {:.2f})^2 + (y - {:.2f})^2 + z^2 - 0.0016); ",
                               0.1 * (k % 20) - 0.95, 0.1 * (k / 20) - 0.95);
    }
    const std::string text = scene_text(formula + "m", "camera.position = [0, 0, 6]\n"
                                                       "camera.up = [0, 1, 0]\n");
    const scene::Scene scene = scene_of(text);
    ASSERT_GT(shader::assemble(scene).size_compiled, shader::largest_shaders());
    const Picture picture = draw(*context, scene);
    const std::int64_t hits = count(picture, Verdict::hit);
    EXPECT_EQ(count(picture, Verdict::hit) + count(picture, Verdict::miss), 48 * 48);
    // Balls of radius 0.04 in squares of 0.1 cover half of a square that is 1.98 across, and that
    // an eye at 6 with a field of view of 40 degrees sees some 22 pixels across.
    EXPECT_NEAR(double(hits), 0.5 * 22 * 22, 60);
}

// Three slopes of each sine would take more turns of the interpreter than a shader can.
TEST_P(Tapes, TakeALongNormalFromOneTape) {
    std::string waves = "s = 0; ";
    for (int k = 1; k <= 6'000; ++k)
        waves += fmt::format("s = 1.0001*(s + sin({}*x + {}*y)); ", k, k % 7);
    const scene::Scene scene = scene_of(scene_text(waves + "x^2 + y^2 + z^2 - 1 + 0.0000000001*s"));
    const shader::Passes passes = shader::assemble(scene);
    ASSERT_TRUE(passes.tapes);
    using enum shader::FieldFunction;
    EXPECT_EQ(passes.tapes->run_for(gradient), gradient);
    EXPECT_LT(passes.tapes->cost({gradient}).iterations,
              1.5 * passes.tapes->cost({directional}).iterations);
    using enum shader::Channel;
    Renderer renderer(*context, scene, {12, 12, {verdict, normal, position}});
    const Picture picture = renderer.draw(scene::at_frame(scene, 1));
    EXPECT_EQ(count(picture, Verdict::hit) + count(picture, Verdict::miss), 12 * 12);
    // A sphere's, but for the waves' slope of 0.002 at most.
    int hits = 0;
    const auto& verdicts = picture.frame.find("verdict")->samples;
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        if (verdicts[k] != float(Verdict::hit)) continue;
        ++hits;
        for (const std::string axis : {"X", "Y", "Z"}) {
            EXPECT_NEAR(picture.frame.find("N." + axis)->samples[k],
                        picture.frame.find("P." + axis)->samples[k], 0.004);
        }
    }
    EXPECT_GT(hits, 12 * 12 / 8);
}

TEST_P(Tapes, TakeAShortNormalFromSlopes) {
    const RunEach run;
    const shader::Passes passes = shader::assemble(scene_of(scene_text("x^2 + y^2 + z^2 - 1")));
    ASSERT_TRUE(passes.tapes);
    using enum shader::FieldFunction;
    EXPECT_EQ(passes.tapes->run_for(gradient), directional);
}

// Loops over elements are written out, since tapes have none.
TEST_P(Tapes, GoThroughElements) {
    const std::string moving = "[time]\nframes = 30\nfps = 30\n";
    const std::string balls =
        "[arrays.b]\ncount = 3\nbx = \"i/2 - 0.5 + t/5\"\nbr = [0.2, 0.3, 0.4]\n";
    const std::string posts = "[arrays.p]\ncount = 2\npy = \"0.8*i - 0.4\"\n";
    for (const char* formula : {
             "sum(b, exp(-8*((x - bx)^2 + y^2 + z^2)/br)) - 0.5",
             "least(b, sqrt((x - bx)^2 + y^2 + z^2) - br)",
             "min(z + 0.3, least(b, (x - bx)^2 + y^2 + z^2 - br^2))",
         })
        expect_alike(*context, scene_text(formula, balls + moving), 20);
    expect_alike(*context,
                 scene_text("sum(b, sum(p, exp(-8*((x - bx)^2 + (y - py)^2 + z^2)/br))) - 0.5",
                            balls + posts + moving),
                 20);
    // many, which beams or a grid would find
    expect_alike(*context,
                 scene_text("sum(b, exp(-20*((x - bx)^2 + (y - by)^2 + z^2))) - 0.3",
                            "[arrays.b]\ncount = 100\nbx = \"(i - 10*floor(i/10))/5 - 0.9\"\n"
                            "by = \"floor(i/10)/5 - 0.9\"\n"));
}

TEST_P(Tapes, HaveNoneForMoreElementsThanFit) {
    const scene::Scene scene = scene_of(scene_text("sum(b, exp(-(x - bx)^2 - y^2 - z^2)) - 0.5",
                                                   "[arrays.b]\ncount = 60000\nbx = \"i/4\"\n"));
    const RunEach run;
    EXPECT_FALSE(shader::assemble(scene).tapes);
}

} // namespace
} // namespace isomotion::render::tapes_test
