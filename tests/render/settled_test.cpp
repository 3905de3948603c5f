// Blocks of rays whose beam tells where their first roots are: pictures with and without beams
// agree.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

struct Pictures {
    Picture marched, settled; // without beams, and with them
    int hits = 0;
    int of_other_verdict = 0, of_other_depth = 0; // pixels
};

class Settled : public Drawing {
protected:
    // By default of a size that is no multiple of a block's.
    static scene::Scene surface(const std::string& name, const std::string& size = "[97, 61]") {
        return scene_of(fmt::format("[surface]\nuse = '{}'\n[output]\nsize = {}\n", name, size));
    }

    Pictures pictures(scene::Scene scene) {
        scene.surfaces[0].isolation.method = scene::Method::hermite;
        const auto drawn = [&](bool beam) {
            scene.surfaces[0].isolation.beam = beam;
            return draw(*context, scene);
        };
        Pictures both{drawn(false), drawn(true)};
        const auto channel = [](const Picture& picture, const char* name) {
            return std::span<const float>(picture.frame.find(name)->samples);
        };
        const auto is_hit = [](float verdict) {
            return Verdict(int(verdict)) == Verdict::hit ||
                   Verdict(int(verdict)) == Verdict::zero_gradient;
        };
        for (std::size_t k = 0; k < channel(both.marched, "Z").size(); ++k) {
            const bool hits = is_hit(channel(both.marched, "verdict")[k]);
            const bool also = is_hit(channel(both.settled, "verdict")[k]);
            const float depth = channel(both.marched, "Z")[k];
            both.hits += hits;
            both.of_other_verdict += hits != also;
            both.of_other_depth +=
                hits && also && std::abs(channel(both.settled, "Z")[k] - depth) > 1e-3f * depth;
        }
        return both;
    }
};
ISOMOTION_ON_EVERY_BACKEND(Settled);

TEST_P(Settled, RaysFindWhatOthersFind) {
    for (const char* name : {"goursat", "cayley", "kummer", "barth_sextic", "steiner", "heart",
                             "klein_bottle", "chmutov_8"}) {
        SCOPED_TRACE(name);
        const Pictures both = pictures(surface(name));
        EXPECT_GT(both.hits, 500);
        EXPECT_LE(both.of_other_verdict, 1);
        EXPECT_LE(both.of_other_depth, 1);
    }
}

TEST_P(Settled, RaysOfSmoothSheetsTakeFewSamples) {
    for (const char* name : {"goursat", "barth_sextic"}) {
        SCOPED_TRACE(name);
        const Pictures both = pictures(surface(name, "[512, 512]"));
        EXPECT_LE(both.of_other_verdict, 1);
        EXPECT_LT(double(both.settled.evaluations()), 0.75 * double(both.marched.evaluations()));
    }
}

TEST_P(Settled, RaysOfAnyCameraFindWhatOthersFind) {
    for (const char* camera :
         {"position = [0.9, 0.1, 0.2]\ntarget = [0, 0, 0]\n", // within the bounds, outside of the
                                                              // surface
          "position = [0.1, 0.2, 0.3]\ntarget = [1, 1, 1]\n", // within both
          "position = [3, 1, 2]\ntarget = [0, 0, 0]\nprojection = 'orthographic'\nheight = 1.7\n",
          "position = [40, 3, 2]\ntarget = [0, 0, 0]\nfov = 3\n",
          // the eye of parallel rays before what they would meet behind it, and within the surface
          "position = [0.5, 0.1, 0.2]\ntarget = [0, 0, 0]\nprojection = 'orthographic'\nheight = "
          "1.7\n",
          "position = [0.2, 0.1, 0.05]\ntarget = [0, 0, 0]\nprojection = 'orthographic'\nheight = "
          "0.5\n"}) {
        for (const char* bounds :
             {"{ sphere = 1.3 }", "{ box = [[-0.7, -0.8, -0.9], [0.6, 0.7, 0.8]] }"}) {
            SCOPED_TRACE(std::string(camera) + bounds);
            const Pictures both = pictures(scene_of(fmt::format(R"([surface]
formula = "x^4 + 2*y^4 + z^4 - x*y*z - 0.3*x - 0.15"
bounds = {}
[camera]
{}
[output]
size = [97, 61]
)",
                                                                bounds, camera)));
            EXPECT_GT(both.hits, 100);
            EXPECT_LE(both.of_other_verdict, 1);
            EXPECT_LE(both.of_other_depth, 1);
        }
    }
}

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

TEST_P(Settled, NothingBehindTheEyeIsSeen) {
    const Pictures both = pictures(scene_of(R"scene([surface]
formula = "x^4 + 2*y^4 + z^4 - x*y*z - 0.3*x - 0.15"
bounds = { sphere = 1.3 }
[camera]
position = [-3, 0.1, 0.25]
target = [-5, 0, 0]
projection = "orthographic"
height = 1.7
[output]
size = [97, 61]
)scene"));
    EXPECT_EQ(count(both.settled, Verdict::miss), 97 * 61);
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

TEST_P(Settled, TilesAndPassesChangeNoBit) {
    for (const char* name : {"barth_sextic", "goursat", "torus_quartic"}) {
        SCOPED_TRACE(name);
        const scene::Scene scene = surface(name, "[300, 280]");
        const Picture whole = draw(*context, scene);
        MarchPlan tiles{.tile_width = 256, .tile_height = 256, .evaluations_per_pass = 64};
        EXPECT_TRUE(same_bits(whole.frame, draw(*context, scene, 1, tiles).frame));
        MarchPlan steps = tiles;
        steps.evaluations_per_pass = 1;
        EXPECT_TRUE(same_bits(whole.frame, draw(*context, scene, 1, steps).frame));
    }
}

} // namespace
} // namespace isomotion::render
