// Compute shaders march the rays as fragment shaders do, and who chooses which.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gpu/compute.h"
#include "gpu/error.h"
#include "scene/reading/load.h"
#include "shader/assemble.h"
#include "shader/beam_text.h"

namespace isomotion::render {
namespace {

class StageOf : public Drawing {
protected:
    void SetUp() override {
        Drawing::SetUp();
        if (context && !gpu::has_compute(context->info())) {
            GTEST_SKIP() << "no compute shaders: OpenGL " << context->info().version;
        }
    }

    // Draws with beams in both stages or in none: compute shaders have fewer by themselves.
    Picture draw_by(StageChoice stage, scene::Scene scene, int frame,
                    std::optional<MarchPlan> plan = {}) {
        scene.surfaces[0].isolation.beam = shader::uses_beams(scene);
        RenderOptions options{scene.output.width, scene.output.height, every_channel, plan};
        options.stage = stage;
        Renderer renderer(*context, scene, options);
        return renderer.draw(scene::at_frame(scene, frame));
    }

    // Fragments march and shade in one draw, compute shaders only march: two programs, in which a
    // driver may reorder arithmetic differently. Measured on llvmpipe: most pictures are equal to
    // the bit; of sums over arrays some pixels take an evaluation more or fewer and hits move by
    // their last bits.
    void expect_same(const scene::Scene& scene, int frame, std::optional<MarchPlan> plan = {}) {
        const Picture fragment = draw_by(StageChoice::fragment, scene, frame, plan);
        const Picture compute = draw_by(StageChoice::compute, scene, frame, plan);
        EXPECT_GT(count(fragment, Verdict::hit), 0);
        const auto layer = [](const Picture& picture, const char* name) {
            return std::span<const float>(picture.frame.find(name)->samples);
        };
        const auto a = layer(fragment, "verdict"), b = layer(compute, "verdict");
        const auto depth = layer(fragment, "Z"), depth_too = layer(compute, "Z");
        int other_verdicts = 0, other_depths = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            other_verdicts += a[k] != b[k];
            if (a[k] != b[k] || Verdict(int(a[k])) != Verdict::hit) continue;
            other_depths += std::abs(depth[k] - depth_too[k]) > 1e-5 * depth[k];
        }
        EXPECT_LE(other_verdicts, 1);
        EXPECT_LE(other_depths, 1);
        EXPECT_NEAR(double(fragment.evaluations()), double(compute.evaluations()),
                    1e-2 * double(fragment.evaluations()));
    }
};
ISOMOTION_ON_EVERY_BACKEND(StageOf);

// As users draw: compute shaders take no beams here, and fragments do. Only evaluations differ.
TEST_P(StageOf, ComputeShadersWithoutBeamsHitTheSame) {
    for (const char* name : {"barth_sextic", "goursat"}) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene::load(name, {"look=none", "output.size=[183,129]"});
        const auto drawn = [&](StageChoice stage) {
            RenderOptions options{183, 129, every_channel};
            options.stage = stage;
            Renderer renderer(*context, scene, options);
            return renderer.draw(scene::at_frame(scene, 31));
        };
        const Picture fragment = drawn(StageChoice::fragment),
                      compute = drawn(StageChoice::compute);
        EXPECT_GT(count(fragment, Verdict::hit), 0);
        EXPECT_NE(fragment.evaluations(), compute.evaluations()); // beams leave less of the way
        const auto layer = [](const Picture& picture, const char* channel) {
            return std::span<const float>(picture.frame.find(channel)->samples);
        };
        const auto a = layer(fragment, "verdict"), b = layer(compute, "verdict");
        const auto depth = layer(fragment, "Z"), depth_too = layer(compute, "Z");
        for (std::size_t k = 0; k < a.size(); ++k) {
            ASSERT_EQ(a[k], b[k]) << "pixel " << k;
            if (Verdict(int(a[k])) != Verdict::hit) continue;
            ASSERT_NEAR(depth[k], depth_too[k], 1e-5 * depth[k]) << "pixel " << k;
        }
    }
}

// Compute shaders settle blocks of large pictures, as beams in fragments do.
TEST_P(StageOf, ComputeShadersSettleBlocksOfLargePictures) {
    for (const auto& [name, in_tiles] : {std::pair{"goursat", false}, {"chmutov_8", true}}) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene::load(name, {"look=none", "output.size=[1500,1400]"});
        const auto drawn = [&](StageChoice stage, std::optional<MarchPlan> plan) {
            RenderOptions options{1500, 1400, {shader::Channel::depth}, plan};
            options.stage = stage;
            Renderer renderer(*context, scene, options);
            return renderer.draw(scene::at_frame(scene, 31));
        };
        const std::optional<MarchPlan> tiles = MarchPlan{700, 500, 4};
        const Picture fragment = drawn(StageChoice::fragment, {});
        const Picture compute = drawn(StageChoice::compute, in_tiles ? tiles : std::nullopt);
        const double hits = double(count(fragment, Verdict::hit));
        EXPECT_GT(hits, 100'000);
        // Two or three samples a ray; without beams it is 6 to 9.
        EXPECT_LT(double(compute.evaluations()), 4.5 * hits);
        EXPECT_EQ(compute.verdicts, fragment.verdicts);
        const auto& a = fragment.frame.find("Z")->samples;
        const auto& b = compute.frame.find("Z")->samples;
        int other = 0;
        for (std::size_t k = 0; k < a.size(); ++k)
            other += std::abs(a[k] - b[k]) > 1e-5 * std::abs(a[k]);
        EXPECT_EQ(other, 0);
    }
}

// Neither side of the picture is a multiple of a work group's. Among the scenes: a high degree, a
// sum over an array in a block, a sphere and a box as bounds.
TEST_P(StageOf, ChangesLastBitsAtMostWhateverTheMethod) {
    for (const char* name :
         {"barth_decic", "barth_sextic", "goursat", "blobby75", "twisting_superquadric"}) {
        for (const scene::MethodTraits& method : scene::method_traits) {
            SCOPED_TRACE(fmt::format("{} {}", name, method.name));
            expect_same(scene::load(name, {"look=none", "output.size=[61,43]",
                                           fmt::format("isolation.method=\"{}\"", method.name)}),
                        31);
        }
    }
}

TEST_P(StageOf, ChangesLastBitsAtMostWhateverTheTilesAndPasses) {
    const scene::Scene scene = scene::load("blobby75", {"look=none", "output.size=[70,50]"});
    for (const MarchPlan plan : {MarchPlan{70, 50, 1}, MarchPlan{16, 16, 700}, MarchPlan{33, 17, 3},
                                 MarchPlan{64, 8, 50}, MarchPlan{7, 7, 64}}) {
        SCOPED_TRACE(
            fmt::format("{}x{}, {}", plan.tile_width, plan.tile_height, plan.evaluations_per_pass));
        expect_same(scene, 31, plan);
    }
}

// A formula so long that the march takes the gradient too, and an array so long that it is in a
// texture.
TEST_P(StageOf, ChangesLastBitsAtMostOfWhatIsLong) {
    std::string terms = "s = x^2 + y^2 + z^2 - 1; "; // no sum of many, which would be an array's
    for (int k = 1; k < 60; ++k) {
        terms +=
            fmt::format("s = 1.001*(s + sin({}*x)*cos({}*y)*sin({}*z + x)/400); ", k, k + 1, k + 2);
    }
    terms += "s";
    const std::string surface = "[surface]\nbounds = { sphere = 1.5 }\nformula = ";
    const std::string view = "[camera]\nposition = [5, 0, 0]\n[output]\nsize = [21, 19]\n";
    const scene::Scene formula = scene_of(surface + '"' + terms + "\"\n" + view);
    EXPECT_TRUE(shader::assemble(formula).march_takes_gradient);
    expect_same(formula, 1);
    const scene::Scene array =
        scene_of(surface + "\"x^2 + y^2 + z^2 - 1 + sum(links, px*sin(x + px))\"\n" +
                 "[arrays.links]\ncount = 5000\npx = '1e-5*i'\n" + view);
    EXPECT_EQ(shader::assemble(array).arrays.at(0).kind,
              shader::ArrayStorage::Kind::texture_buffer);
    expect_same(array, 1);
}

// Drivers may reorder a formula's arithmetic otherwise from stage to stage, and do of this sum: F
// then differs in its last bits, from which hermite takes its steps. Measured on llvmpipe: of 6603
// pixels 58 took up to 2 evaluations more or fewer, and one hit moved by 3e-8.
TEST_P(StageOf, MovesHitsByLastBitsAtMost) {
    const scene::Scene scene = scene::load(
        "falling_drops", {"look=none", "output.size=[93,71]", "isolation.method=\"hermite\""});
    const Picture fragment = draw_by(StageChoice::fragment, scene, 55);
    const Picture compute = draw_by(StageChoice::compute, scene, 55);
    EXPECT_GT(count(fragment, Verdict::hit), 1000);
    const auto layer = [](const Picture& picture, const char* name) {
        return std::span<const float>(picture.frame.find(name)->samples);
    };
    const auto a = layer(fragment, "verdict"), b = layer(compute, "verdict");
    const auto depth = layer(fragment, "Z"), depth_too = layer(compute, "Z");
    for (std::size_t k = 0; k < a.size(); ++k) {
        ASSERT_EQ(a[k], b[k]) << "pixel " << k;
        if (Verdict(int(a[k])) != Verdict::hit) continue;
        ASSERT_NEAR(depth[k], depth_too[k], 1e-6 * depth[k]) << "pixel " << k;
    }
    EXPECT_NEAR(double(fragment.evaluations()), double(compute.evaluations()),
                1e-3 * double(fragment.evaluations()));
}

// Mirrored rays and shadow rays are marched by the same stage.
TEST_P(StageOf, ChangesLastBitsAtMostOfShadowsAndMirrors) {
    const std::string torus = R"toml(
[surface]
formula = "(x^2 + y^2 + z^2 + 0.6)^2 - 2.6*(x^2 + y^2)"
bounds = { sphere = 2 }
[camera]
position = [3, 2, 3]
target = [0, 0, 0]
fov = 40
[output]
size = [61, 43]
[material]
reflection = "self"
[[lights]]
direction = [1, 2, 3]
shadow = true
[[lights]]
position = [0, 4, 1]
shadow = true
)toml";
    for (const char* method : {"amp-sign", "amp-taylor", "hermite"}) {
        SCOPED_TRACE(method);
        expect_same(scene_of(torus, {fmt::format("isolation.method=\"{}\"", method)}), 1);
    }
}

TEST_P(StageOf, FingerprintsTellStagesApart) {
    const scene::Scene scene = scene_of(sphere_scene);
    const auto print = [&](StageChoice stage) {
        RenderOptions options{8, 8, {}, {}};
        options.stage = stage;
        return Renderer(*context, scene, options).prepare(scene, 1).fingerprint;
    };
    EXPECT_NE(print(StageChoice::fragment), print(StageChoice::compute));
    // The drivers of these tests are no data-centre GPUs, or this is where it shows.
    const auto here = choose_stage(StageChoice::automatic, context->info());
    EXPECT_EQ(print(StageChoice::automatic),
              print(here == shader::Stage::compute ? StageChoice::compute : StageChoice::fragment));
}

gpu::ContextInfo driver(const char* renderer, int major, int minor, bool software = false) {
    gpu::ContextInfo info;
    info.renderer = renderer;
    info.major = major;
    info.minor = minor;
    info.software = software;
    return info;
}

TEST(ChooseStage, AutoTakesComputeOnDataCentreGpusAlone) {
    const auto chosen = [](const gpu::ContextInfo& info) {
        return choose_stage(StageChoice::automatic, info);
    };
    for (const char* name : {"NVIDIA H200/PCIe/SSE2", "NVIDIA H100 80GB HBM3/PCIe/SSE2",
                             "NVIDIA GH200 480GB", "NVIDIA H100"}) {
        EXPECT_EQ(chosen(driver(name, 4, 5)), shader::Stage::compute) << name;
        EXPECT_EQ(chosen(driver(name, 4, 3)), shader::Stage::compute) << name;
        EXPECT_EQ(chosen(driver(name, 4, 2)), shader::Stage::fragment) << name;
        EXPECT_EQ(chosen(driver(name, 4, 5, true)), shader::Stage::fragment) << name;
    }
    for (const char* name :
         {"llvmpipe (LLVM 15.0.6, 256 bits)", "NVIDIA GeForce RTX 4090/PCIe/SSE2", "NVIDIA H2000",
          "XH200", "Mesa Intel(R) UHD Graphics 620", ""}) {
        EXPECT_EQ(chosen(driver(name, 4, 6)), shader::Stage::fragment) << name;
    }
}

TEST(ChooseStage, ComputeIsRefusedBelow43) {
    for (const auto& [major, minor] : {std::pair{3, 3}, {4, 0}, {4, 2}}) {
        try {
            choose_stage(StageChoice::compute, driver("some driver", major, minor));
            ADD_FAILURE() << major << "." << minor;
        } catch (const gpu::ResourceError& error) {
            EXPECT_EQ(error.what(), fmt::format("--stage compute: needs OpenGL 4.3, this driver "
                                                "has {}.{} (some driver)",
                                                major, minor));
        }
        EXPECT_EQ(choose_stage(StageChoice::fragment, driver("", major, minor)),
                  shader::Stage::fragment);
    }
    for (const auto& [major, minor] : {std::pair{4, 3}, {4, 6}, {5, 0}}) {
        EXPECT_EQ(choose_stage(StageChoice::compute, driver("", major, minor)),
                  shader::Stage::compute);
    }
}

TEST(ChooseStage, NamesAreThoseOfTheCommandLine) {
    EXPECT_EQ(parse_stage("fragment"), StageChoice::fragment);
    EXPECT_EQ(parse_stage("compute"), StageChoice::compute);
    EXPECT_EQ(parse_stage("auto"), StageChoice::automatic);
    try {
        parse_stage("Compute");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "--stage: there is no stage 'Compute'; known: fragment, "
                                   "compute, auto");
    }
}

} // namespace
} // namespace isomotion::render
