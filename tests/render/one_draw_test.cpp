// March and picture in one draw, or in passes: the same picture.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/reading/load.h"

namespace isomotion::render {
namespace {

class OneDraw : public Drawing {
protected:
    // Rays that a draw leaves unfinished send the picture through passes.
    Picture in_passes(const scene::Scene& scene, int frame, int evaluations) {
        return draw(*context, scene, frame,
                    MarchPlan{scene.output.width, scene.output.height, evaluations});
    }
    // Expects the same picture of every method that can draw the scene.
    void expect_same(const char* name);
};
ISOMOTION_ON_EVERY_BACKEND(OneDraw);

int different_pixels(const Picture& a, const Picture& b, const char* channel, double tolerance) {
    const auto &x = a.frame.find(channel)->samples, &y = b.frame.find(channel)->samples;
    int different = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (x[k] == y[k]) continue; // infinite depths among them
        different += !(std::abs(double(x[k]) - double(y[k])) <= tolerance);
    }
    return different;
}

// Drivers may order a formula's arithmetic otherwise from shader to shader: then F differs by last
// bits, by which cubics take other steps. What they find is the same within what refining leaves.
void OneDraw::expect_same(const char* name) {
    for (const scene::MethodTraits& entry : scene::method_traits) {
        SCOPED_TRACE(fmt::format("{} {}", name, entry.name));
        const scene::Scene scene =
            scene::load(name, {"look=none", "output.size=[61,43]",
                               fmt::format("isolation.method=\"{}\"", entry.name)});
        const int frame = scene.output.poster;
        const Picture one = in_passes(scene, frame, 60'000);
        EXPECT_EQ(one.passes, 1);
        for (const int evaluations : {1, 3, 50}) {
            const Picture passes = in_passes(scene, frame, evaluations);
            if (evaluations == 1) {
                EXPECT_GT(passes.passes, 1);
            }
            if (same_bits(one.frame, passes.frame)) continue;
            std::string told;
            for (const char* channel : {"verdict", "evaluations", "Z", "R"}) {
                told += fmt::format(" {} {}", channel, different_pixels(one, passes, channel, 0));
            }
            EXPECT_LE(different_pixels(one, passes, "verdict", 0), 1) << told;
            EXPECT_LE(different_pixels(one, passes, "Z", 1e-4), 1) << told;
            EXPECT_LE(different_pixels(one, passes, "R", 1e-2), 3) << told;
            EXPECT_NEAR(double(one.evaluations()), double(passes.evaluations()),
                        0.01 * double(one.evaluations()));
        }
    }
}

TEST_P(OneDraw, IsThePictureOfPassesForPolynomials) {
    for (const char* name : {"torus_quartic", "barth_sextic", "goursat"}) expect_same(name);
}

TEST_P(OneDraw, IsThePictureOfPassesForRootsAndPowers) {
    for (const char* name : {"torus", "superquadric", "twisting_superquadric"}) expect_same(name);
}

TEST_P(OneDraw, IsThePictureOfPassesForSums) {
    for (const char* name : {"blobby75", "falling_drops"}) expect_same(name);
}

// Once a ray has not ended in one draw, pictures after it go through passes: nothing shows.
TEST_P(OneDraw, TheNextFrameIsTheSameByEither) {
    // With a uniform of its own: the colour of the other side.
    const scene::Scene scene = scene::load("barth_sextic", {"look=none", "output.size=[40,30]"});
    const auto now = [&](int frame) { return scene::at_frame(scene, frame); };
    Renderer renderer(*context, scene, {40, 30, every_channel, MarchPlan{40, 30, 4}});
    const Picture first = renderer.draw(now(1)), again = renderer.draw(now(1));
    EXPECT_GT(again.passes, 1);
    EXPECT_EQ(first.passes, again.passes + 1); // the draw that did not suffice
    EXPECT_TRUE(same_bits(first.frame, again.frame));
    EXPECT_EQ(first.verdicts, again.verdicts);
    EXPECT_EQ(first.evaluations(), again.evaluations());
}

// Hardware is asked for all at once, software renderers part by part: of plain scenes with and
// without beams, of several tiles, and of scenes with passes.
TEST_P(OneDraw, IsReadBackTheSameAtOnceAndInParts) {
    for (const char* name : {"goursat", "chmutov_8", "superquadric", "chmutov_12_two_lights"}) {
        for (const bool tiles : {false, true}) {
            SCOPED_TRACE(fmt::format("{}{}", name, tiles ? " in tiles" : ""));
            const scene::Scene scene = scene::load(name, {"look=none", "output.size=[301,173]"});
            const auto read = [&](bool at_once) {
                RenderOptions options{301, 173, every_channel};
                if (tiles) options.plan = MarchPlan{128, 64, 60'000};
                options.reads_at_once = at_once;
                Renderer renderer(*context, scene, options);
                return renderer.draw(scene::at_frame(scene, 2));
            };
            const Picture at_once = read(true), in_parts = read(false);
            EXPECT_GT(count(at_once, Verdict::hit), 1000);
            EXPECT_TRUE(same_bits(at_once.frame, in_parts.frame));
            EXPECT_EQ(at_once.verdicts, in_parts.verdicts);
            EXPECT_EQ(at_once.evaluations(), in_parts.evaluations());
        }
    }
}

} // namespace
} // namespace isomotion::render
