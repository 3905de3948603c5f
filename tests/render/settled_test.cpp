// Blocks of rays whose beam tells where their first roots are (scenes/settled.toml compares them
// with rays without beams).
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

class Settled : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Settled);

// Five planes in any order, two of them close together: whichever a ray meets first is seen, to a
// fifth of a pixel.
TEST_P(Settled, NoSheetIsSkippedForOneBehind) {
    std::string formula = "1", parameters;
    for (int k = 0; k < 5; ++k) {
        // A pair is 2^-3 to 2^-20 thick.
        const std::string place =
            k == 4 ? "a3 - 2^(-3 - 17*random(t, 9))" : fmt::format("random(t, {}) - 0.5", k);
        const std::string lean =
            k == 4 ? "b3 + 0.001*random(t, 10)" : fmt::format("random(t, {}) - 0.5", 10 + k);
        formula += fmt::format("*(x - a{0} - b{0}*y - c{0}*z)", k);
        parameters += fmt::format("a{0} = '{1}'\nb{0} = '{2}'\nc{0} = 'random(t, {3}) - 0.5'\n", k,
                                  place, lean, 20 + std::min(k, 3));
    }
    constexpr int frames = 150, side = 64;
    const scene::Scene scene = scene_of(fmt::format(R"scene([time]
fps = 1
frames = {}
[surface]
formula = "{}"
bounds = {{ box = [[-2, -2, -2], [2, 2, 2]] }}
[parameters]
{}
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 0.6
[isolation]
method = "hermite"
[output]
size = [{}, {}]
)scene",
                                                    frames, formula, parameters, side, side));
    Renderer renderer(*context, scene, {side, side, every_channel, {}});
    for (int frame = 1; frame <= frames; ++frame) {
        const scene::SceneAt now = scene::at_frame(scene, frame);
        const Picture picture = renderer.draw(now);
        const auto& x = picture.frame.find("P.X")->samples;
        const auto& y = picture.frame.find("P.Y")->samples;
        const auto& z = picture.frame.find("P.Z")->samples;
        for (std::size_t k = 0; k < x.size(); ++k) {
            double first = -2;
            for (std::size_t plane = 0; plane < 5; ++plane) {
                const float* abc = now.surfaces[0].bindings.parameters.data() + plane; // by name
                first = std::max(first, double(abc[0]) + double(abc[5]) * double(y[k]) +
                                            double(abc[10]) * double(z[k]));
            }
            ASSERT_NEAR(x[k], first, 0.002) << "frame " << frame << ", pixel " << k;
        }
    }
}

// Trimmed parts of beams prove rays that end; others gave up on the way.
TEST_P(Settled, WhatGaveUpIsNotProved) {
    std::int64_t gave_up = 0;
    for (const char* formula : {"z^2 + 1e-8", "x^4 + 2*y^4 + z^4 - x*y*z - 0.3*x - 0.15",
                                "x^2*y^2 + y^2*z^2 + z^2*x^2 + 1e-5"}) {
        SCOPED_TRACE(formula);
        const scene::Scene scene = scene_of(fmt::format(R"scene([surface]
formula = "{}"
bounds = {{ sphere = 1.3 }}
[camera]
position = [3, 1, 2]
target = [0, 0, 0]
[isolation]
method = "hermite"
limit = 3
certify = true
[output]
size = [128, 128]
)scene",
                                                        formula));
        std::vector<shader::Channel> channels = every_channel;
        channels.push_back(shader::Channel::proof);
        Renderer renderer(*context, scene, {128, 128, channels, {}});
        const Picture picture = renderer.draw(scene::at_frame(scene, 1));
        const auto& verdict = picture.frame.find("verdict")->samples;
        const auto& proof = picture.frame.find("proof")->samples;
        gave_up += count(picture, Verdict::step_limit);
        for (std::size_t k = 0; k < verdict.size(); ++k) {
            if (Verdict(int(verdict[k])) != Verdict::step_limit) continue;
            ASSERT_NE(Proof(int(proof[k])), Proof::miss) << k;
            ASSERT_NE(Proof(int(proof[k])), Proof::hit) << k;
        }
    }
    EXPECT_GT(gave_up, 50);
}

} // namespace
} // namespace isomotion::render
