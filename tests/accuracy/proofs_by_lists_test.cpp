// Proofs that go through lists of beams: what they call proved is so of all elements, also where
// the march is wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/drawing.h"
#include "shader/assemble.h"

namespace isomotion::accuracy {
namespace {

using render::Picture, render::Proof, render::scene_of;

constexpr int width = 61, height = 45;
constexpr float pixel = 2.9f / height;

// 120 elements in a ball.
scene::Scene listed_scene(const std::string& formula, const std::string& isolation,
                          const std::string& bounds = "sphere = 1.4") {
    std::string text = fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ {} }}\n"
                                   "[arrays.p]\ncount = 120\n",
                                   formula, bounds);
    for (int k = 0; k < 3; ++k)
        text += fmt::format("c{} = \"1.8*random(i, {}) - 0.9\"\n", "xyz"[k], k);
    if (formula.find('w') != formula.npos) text += "w = \"0.7 + 0.6*random(i, 3)\"\n";
    return scene_of(fmt::format("{}[camera]\nazimuth = 30\nelevation = 20\n"
                                "[output]\nsize = [{}, {}]\n[isolation]\n{}",
                                text, width, height, isolation));
}

Picture drawn(gpu::Context& context, const scene::Scene& scene) {
    auto channels = render::every_channel;
    if (scene.surfaces[0].isolation.certify) channels.push_back(shader::Channel::proof);
    render::Renderer renderer(context, scene, {width, height, channels, {}});
    return renderer.draw(scene::at_frame(scene, 1));
}

class ProofsByLists : public render::Drawing {
protected:
    void expect_true(const std::string& formula, const std::string& bounds = "sphere = 1.4") {
        SCOPED_TRACE(formula);
        const scene::Scene marched = listed_scene(
            formula, "certify = true\nbeam = true\nmethod = \"amp-sign\"\nstep = 0.4\n", bounds);
        EXPECT_TRUE(shader::has_lists(shader::assemble(marched)));
        const scene::Scene all =
            listed_scene(formula, "method = \"interval\"\nbeam = false\n", bounds);
        const Picture proved = drawn(*context, marched), right = drawn(*context, all);
        const auto of = [](const Picture& picture, const char* channel) {
            return std::span<const float>(picture.frame.find(channel)->samples);
        };
        for (std::size_t k = 0; k < of(proved, "proof").size(); ++k) {
            const bool differs = of(proved, "verdict")[k] != of(right, "verdict")[k] ||
                                 std::abs(of(proved, "Z")[k] - of(right, "Z")[k]) > 0.25f * pixel;
            wrong_ += differs;
            ++pixels_;
            if (!render::is_proved(Proof(int(of(proved, "proof")[k])))) continue;
            ++proved_;
            EXPECT_FALSE(differs) << k % width << "," << k / width << " is proved and wrong";
        }
    }

    int proved_ = 0, wrong_ = 0, pixels_ = 0;
};
ISOMOTION_ON_EVERY_BACKEND(ProofsByLists);

TEST_P(ProofsByLists, HoldForAllElements) {
    expect_true("sum(p, exp(-60*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5");
    expect_true("0.3 - sum(p, w*max(0, 1 - 20*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^3)");
    expect_true("(2 + x)*(sum(p, 0.01*exp(-60*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))/3 - 0.002) "
                "+ 0.001*z",
                "box = [[-1, -1, -0.9], [1, 0.8, 1]]");
    EXPECT_GT(proved_, 0.6 * pixels_);
    EXPECT_GT(wrong_, 60); // else nothing is tested
}

} // namespace
} // namespace isomotion::accuracy
