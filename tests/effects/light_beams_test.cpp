// Shadow rays by beams of the lights': the shadows are those of rays that go all their way.
#include <array>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "render/drawing.h"
#include "scene/data_folder.h"

namespace isomotion::render {
namespace {

gpu::Context& context() {
    static const auto it = gpu::Context::create();
    return *it;
}

struct Lit {
    Picture with, without; // beams; both of the eye's and the lights'
};

class LightBeams : public testing::Test {
protected:
    // Draws an animation's poster, white all over, under these lights, with beams and without.
    Lit drawn(const std::string& name, const std::string& lights, std::array<int, 2> size,
              const std::string& ground = {}, std::optional<MarchPlan> plan = {}) {
        std::ifstream file(scene::data_folder() / "animations" / (name + ".toml"));
        std::string text((std::istreambuf_iterator<char>(file)), {});
        for (std::size_t at; (at = text.find("[[lights]]")) != std::string::npos;) {
            text.erase(at, text.find("\n\n", at) - at);
        }
        // Cubics fit kinks badly: bounds alone find these roots.
        const char* method = name == "superquadric" ? "affine" : "hermite";
        const auto picture = [&](bool beam) {
            const scene::Scene scene =
                scene_of(text + "\n" + lights + ground,
                         {"look=none", "material.color=[1,1,1]",
                          fmt::format("isolation.method=\"{}\"", method),
                          fmt::format("isolation.beam={}", beam),
                          fmt::format("output.size=[{},{}]", size[0], size[1])});
            return draw(context(), scene, scene.output.poster, plan);
        };
        return {picture(true), picture(false)};
    }
    // Pixels that one has in the light and the other in the dark, of those that both hit.
    static int different(const Lit& lit) {
        const auto layer = [](const Picture& picture, const char* name) {
            return std::span<const float>(picture.frame.find(name)->samples);
        };
        int different = 0;
        for (std::size_t k = 0; k < layer(lit.with, "R").size(); ++k) {
            if (layer(lit.with, "verdict")[k] != layer(lit.without, "verdict")[k]) continue;
            different += std::abs(layer(lit.with, "R")[k] - layer(lit.without, "R")[k]) > 0.02f;
        }
        return different;
    }
};

std::string light(const std::string& from) { return "[[lights]]\n" + from + "\nshadow = true\n"; }

// Rays that pass a silhouette as near as rounding is may fall either way: some pixels in 10,000.
TEST_F(LightBeams, ChangeNoShadow) {
    for (const char* name :
         {"blobby75", "torus", "superquadric", "barth_sextic", "cayley", "wyvill_soft_objects"}) {
        for (const char* from : {"direction = [1, 0.2, 1.4]", "direction = [0, 0, 1]",
                                 "direction = [-0.3, -0.9, 0.2]"}) {
            SCOPED_TRACE(fmt::format("{}, {}", name, from));
            const Lit lit = drawn(name, light(from), {161, 120});
            EXPECT_GT(count(lit.with, Verdict::hit), 1000);
            EXPECT_LE(different(lit), 8);
            EXPECT_LT(lit.with.evaluations(), lit.without.evaluations());
        }
    }
}

// Several, of which one is near and has none; on a ground that reaches beyond every light's view.
TEST_F(LightBeams, OfSeveralLightsAndOnTheGround) {
    const std::string lights = light("direction = [1, 0.2, 1.4]") + light("position = [3, 2, 4]") +
                               light("direction = [-1, 0.5, 0.7]");
    const std::string ground = "[ground]\nheight = -2.2\ncolor = [1, 1, 1]\n";
    for (const char* name : {"blobby75", "torus"}) {
        SCOPED_TRACE(name);
        EXPECT_LE(different(drawn(name, lights, {161, 120}, ground)), 12);
    }
}

// Pictures of more than one square of a light's, in tiles and not.
TEST_F(LightBeams, AtAnySizeAndTiling) {
    for (const char* name : {"blobby75", "torus"}) {
        SCOPED_TRACE(name);
        const std::string from = light("direction = [1, 0.2, 1.4]");
        EXPECT_LE(different(drawn(name, from, {300, 270})), 30);
        EXPECT_LE(different(drawn(name, from, {97, 61}, {}, MarchPlan{37, 23, 20})), 4);
        EXPECT_LE(different(drawn(name, from, {9, 5})), 0);
    }
}

} // namespace
} // namespace isomotion::render
