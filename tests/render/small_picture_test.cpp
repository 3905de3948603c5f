// Small pictures lie about the corner of four squares that a software renderer's threads draw. No
// pixel shows it.
#include "drawing.h"

#include <array>
#include <span>

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

TEST(CornerOfPicture, DividesSmallPicturesInHalves) {
    for (int length = 1; length <= 64; ++length) {
        SCOPED_TRACE(length);
        const glm::ivec2 corner = corner_of_picture(length, 200);
        EXPECT_EQ(corner.x % 8, 0); // blocks of rays stay whole
        EXPECT_EQ(corner.y, 0);
        const int first = std::min(64 - corner.x, length), second = length - first;
        EXPECT_GT(first, 0);
        EXPECT_GE(second, 0);
        EXPECT_LT(std::abs(first - second), 16);
        EXPECT_EQ(corner_of_picture(200, length), glm::ivec2(0, corner.x));
    }
    EXPECT_EQ(corner_of_picture(65, 65), glm::ivec2(0));
    EXPECT_EQ(corner_of_picture(64, 64), glm::ivec2(32));
}

TEST(MarchPlan, TargetsHaveRoomForSmallPictures) {
    MarchPlan plan = plan_march({100, 0}, 64, 20, 2048);
    EXPECT_EQ(plan.target_width(), 64);
    plan.spreads_small_pictures = true;
    for (const int width : {1, 20, 64}) {
        const glm::ivec2 corner = corner_of_picture(width, 64);
        EXPECT_LE(corner.x + width, plan.target_width());
        EXPECT_LE(corner.y + 64, plan.target_height());
    }
    plan.tile_width = 512;
    EXPECT_EQ(plan.target_width(), 512);
}

const std::string particles = R"toml(
look = "studio"
[surface]
formula = "sum(balls, exp(-60*((x-cx)^2 + (y-cy)^2 + (z-cz)^2) )) - 0.5"
bounds = { sphere = 1.5 }
[arrays.balls]
count = 700
cx = "sin(i*1.7)*(1 - i/700)"
cy = "cos(i*2.3)*(1 - i/700)"
cz = "sin(i*0.9 + 1)*0.8"
)toml";

// Settled blocks, beams by intervals, none, elements by place with the shadows of a look; then a
// box, with rays that begin on the surface, and a colour that the surface's bend decides. Then two
// surfaces: in a draw each, with mirrors and with glass that holds water; and glass alone.
const std::array<std::string, 10> scenes{
    sphere_scene,
    "[surface]\nuse = 'superquadric'\n",
    "[surface]\nuse = 'barth_sextic'\n[isolation]\nmethod = 'amp-sign'\nbeam = false\n",
    particles,
    "[surface]\nformula = 'min(x^2 + y^2 - 0.1, abs(z) - 0.1)'\nbounds = { box = [[-1, -0.8, "
    "-0.6], [1, 0.8, 0.6]] }\n"
    "[material]\nreflection = 'self'\n[[lights]]\ndirection = [1, 2, 3]\nshadow = true\n",
    "[surface]\nuse = 'cayley'\n[material.colormap]\nvalue = 'mean_curvature'\nrange = [-2, "
    "2]\n[occlusion]\n",
    "[[surfaces]]\nuse = 'goursat'\n[[surfaces]]\nformula = 'x^2 + y^2 - 0.1 - 0.1*z'\n"
    "bounds = { sphere = 2 }\n",
    "[[surfaces]]\nuse = 'goursat'\n[surfaces.material]\nreflection = 'self'\n"
    "[[surfaces]]\nformula = 'x^2 + y^2 - 0.1 - 0.1*z'\nbounds = { sphere = 2 }\n"
    "[[lights]]\ndirection = [1, 2, 3]\nshadow = true\n[occlusion]\n",
    "[[surfaces]]\nname = 'water'\nformula = 'x^2 + y^2 + z^2 + 0.1*cos(7*x) - 0.8'\n"
    "bounds = { sphere = 1.2 }\n[surfaces.material]\ntransmission = 1\nior = 1.33\n"
    "[[surfaces]]\nname = 'glass'\nformula = 'x^2 + y^2 + z^2 - 1'\n"
    "bounds = { sphere = 1.2 }\n[surfaces.material]\ntransmission = 1\nior = 1.5\n"
    "[ground]\nheight = -1.1\n[[lights]]\ndirection = [1, 2, 3]\nshadow = true\n",
    "[surface]\nformula = 'x^4 + y^4 + z^4 - 0.5'\nbounds = { sphere = 1.2 }\n"
    "[material]\ntransmission = 1\nior = 1.4\n[ground]\nheight = -1\n",
};

class SmallPicture : public Drawing {
protected:
    Picture drawn(const scene::Scene& scene, glm::ivec2 made_for, glm::ivec2 size, bool spreads) {
        RenderOptions options{made_for.x, made_for.y, every_channel, {}};
        options.pixels = std::int64_t(size.x) * size.y;
        if (!spreads) {
            Renderer renderer(*context, scene, options);
            options.plan = renderer.plan();
        }
        Renderer renderer(*context, scene, options);
        EXPECT_EQ(renderer.plan().spreads_small_pictures, spreads && context->info().software);
        renderer.resize(size.x, size.y);
        return renderer.draw(scene::at_frame(scene, 1));
    }
};
ISOMOTION_ON_EVERY_BACKEND(SmallPicture);

TEST_P(SmallPicture, HasTheSameBitsAboutACorner) {
    for (const std::string& text : scenes) {
        SCOPED_TRACE(text);
        const scene::Scene scene = scene_of(text);
        std::int64_t hits = 0;
        const std::array sizes{glm::ivec2(61, 40), glm::ivec2(150, 33), glm::ivec2(64),
                               glm::ivec2(7, 64), glm::ivec2(17, 5)};
        // Programs of many passes compile long.
        const bool has_glass = text.find("transmission") != text.npos;
        for (const glm::ivec2 size : std::span(sizes).first(has_glass ? 2 : sizes.size())) {
            SCOPED_TRACE(fmt::format("{} x {}", size.x, size.y));
            const Picture whole = drawn(scene, size, size, false);
            const Picture spread = drawn(scene, size, size, true);
            EXPECT_TRUE(same_bits(whole.frame, spread.frame));
            EXPECT_EQ(whole.verdicts, spread.verdicts);
            EXPECT_EQ(whole.evaluations(), spread.evaluations());
            hits += count(spread, Verdict::hit);
        }
        EXPECT_GT(hits, 500);
    }
}

// As the player does, which makes renderers for its whole window.
TEST_P(SmallPicture, HasTheSameBitsInARendererOfLargerOnes) {
    for (const std::string& text : scenes) {
        SCOPED_TRACE(text);
        const scene::Scene scene = scene_of(text);
        for (const glm::ivec2 size : {glm::ivec2(64), glm::ivec2(45, 33)}) {
            const Picture whole = drawn(scene, {320, 256}, size, false);
            const Picture spread = drawn(scene, {320, 256}, size, true);
            EXPECT_TRUE(same_bits(whole.frame, spread.frame));
            EXPECT_EQ(whole.evaluations(), spread.evaluations());
        }
    }
}

} // namespace
} // namespace isomotion::render
