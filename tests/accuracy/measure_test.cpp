// Sweeps over settings, drawn and certified.
#include "accuracy/measure.h"

#include <gmock/gmock.h>

#include "render/drawing.h"

namespace isomotion::accuracy {
namespace {

Measurement of(double ms, std::int64_t missed) {
    Measurement m;
    m.ms = ms;
    m.errors.pixels = 1'000'000;
    m.errors.missed = missed;
    return m;
}

TEST(Front, IsWhatNothingBeats) {
    const std::vector<Measurement> all{of(9, 5),  of(1, 100), of(2, 50),
                                       of(3, 60), of(4, 5),   of(2, 70)};
    EXPECT_THAT(front(all), testing::ElementsAre(1u, 2u, 4u));
    EXPECT_EQ(cheapest(all, 1000), 1u);
    EXPECT_EQ(cheapest(all, 50), 2u);
    EXPECT_EQ(cheapest(all, 5), 4u);
    EXPECT_EQ(cheapest(all, 4), std::nullopt);
    EXPECT_EQ(most_accurate(all, 100), 4u);
    EXPECT_EQ(most_accurate(all, 3.5), 2u);
    EXPECT_EQ(most_accurate(all, 0.5), std::nullopt);
}

TEST(Settings, SweepMethodsAndSteps) {
    const scene::Scene scene =
        render::scene_of(render::sphere_scene, {"isolation.step=0.1", "isolation.bisections=7"});
    // Steps for the paper's three, safeties for cubics, the others as they are.
    const auto all = sweep(scene, {}, {});
    EXPECT_EQ(all.size(), 3 * 6 + 4 + (std::size(scene::method_traits) - 4));
    EXPECT_EQ(name(all[0], scene.surfaces[0].isolation), "marching step=0.4");
    EXPECT_EQ(name(all.back(), scene.surfaces[0].isolation), "sphere");
    scene::Scene stepping = scene;
    stepping.surfaces[0].isolation.method = scene::Method::amp_sign;
    const auto more = sweep(stepping, {}, {});
    EXPECT_EQ(more.size(), all.size() + 4);
    EXPECT_EQ(name(more.back(), scene.surfaces[0].isolation), "amp-sign step=0.1 bisections=16");
    const auto few = sweep(scene, {scene::Method::amp_taylor}, {0.3, 0.2});
    ASSERT_EQ(few.size(), 2u);
    EXPECT_EQ(name(few[1], scene.surfaces[0].isolation), "amp-taylor step=0.2");
    const scene::Scene changed = apply({scene::Method::marching, 0.3, 4, 9}, scene);
    EXPECT_EQ(changed.surfaces[0].isolation.method, scene::Method::marching);
    EXPECT_EQ(changed.surfaces[0].isolation.step, 0.3);
    EXPECT_EQ(changed.surfaces[0].isolation.bisections, 9);
    EXPECT_EQ(changed.surfaces[0].isolation.near, 4 * scene.surfaces[0].isolation.near);
    EXPECT_EQ(changed.surfaces[0].isolation.horizon, 4 * scene.surfaces[0].isolation.horizon);
}

// A torus with a tube of 0.1: a step of 0.4 misses most of it, one of 0.01 next to nothing.
TEST(Measure, FinerStepsAreRighterAndCostMore) {
    const auto context = gpu::Context::create();
    const scene::Scene scene = render::scene_of(R"(
[surface]
formula = "(x^2 + y^2 + z^2 + 1 - 0.1^2)^2 - 4*x^2 - 4*y^2"
bounds = { sphere = 1.3 }
)");
    MeasureOptions how;
    how.width = how.height = 64;
    how.repeat = 1;
    std::vector<double> told;
    how.progress = [&](const std::string&, double part) { told.push_back(part); };
    const auto found =
        measure(*context, scene, sweep(scene, {scene::Method::marching}, {0.4, 0.05, 0.01}), how);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_GT(found[0].errors.wrong(), 100);
    EXPECT_GT(found[0].errors.wrong(), found[1].errors.wrong());
    EXPECT_GT(found[1].errors.wrong(), found[2].errors.wrong());
    EXPECT_LE(found[2].errors.wrong(), 4);
    EXPECT_LT(found[0].evaluations_a_ray(), found[2].evaluations_a_ray());
    for (const Measurement& m : found) {
        EXPECT_EQ(m.errors.false_hits, 0); // the sign test invents nothing
        EXPECT_EQ(m.errors.pixels, 64 * 64);
        EXPECT_GT(m.ms, 0);
        EXPECT_GT(m.errors.rays, 0);
        EXPECT_LE(m.errors.rays, m.errors.pixels);
    }
    EXPECT_EQ(told.back(), 1);
}

// A sphere that grows: a coarse step drops pixels at its edge in single frames.
TEST(Measure, SeveralFramesAddUp) {
    const auto context = gpu::Context::create();
    const scene::Scene scene = render::scene_of(R"(
[time]
frames = 6
[surface]
formula = "x^2 + y^2 + z^2 - r^2"
bounds = { sphere = 1.3 }
[parameters]
r = "1 + t/10"
)");
    MeasureOptions how;
    how.frames = {1, 2, 3, 4, 5, 6};
    how.width = how.height = 48;
    how.repeat = 1;
    const auto found =
        measure(*context, scene, sweep(scene, {scene::Method::marching}, {0.9, 0.01}), how);
    EXPECT_EQ(found[0].errors.pixels, 6 * 48 * 48);
    EXPECT_EQ(found[0].errors.faults.size(), 48u * 48);
    EXPECT_GT(found[0].errors.wrong(), found[1].errors.wrong());
    EXPECT_EQ(found[1].pops, 0);
}

// Far from the origin float can't tell hits apart by their place in the world; errors are those of
// the scene at home.
TEST(Measure, PlacementChangesNoError) {
    const auto context = gpu::Context::create();
    const std::string at_home = R"(
[surface]
formula = "x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 0.3"
bounds = { sphere = 1.6 }
transform = { rotate = [20, 30, 40] }
[camera]
position = [4, 2, 1.5]
target = [0, 0, 0]
)";
    const std::string moved = R"(
[surface]
formula = "x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 0.3"
bounds = { sphere = 1.6 }
transform = { rotate = [20, 30, 40], translate = [1e6, -1e6, 1e6], scale = 1000 }
[camera]
position = [1004e3, -998e3, 1001.5e3]
target = [1e6, -1e6, 1e6]
)";
    MeasureOptions how;
    how.width = how.height = 64;
    how.repeat = 1;
    std::vector<Errors> errors;
    for (const std::string& text : {at_home, moved}) {
        const scene::Scene scene = render::scene_of(text);
        errors.push_back(
            measure(*context, scene, sweep(scene, {scene::Method::amp_sign}, {0.02}), how)
                .front()
                .errors);
    }
    EXPECT_GT(errors[0].depth.size(), 500u);
    EXPECT_EQ(errors[0].wrong(), errors[1].wrong());
    EXPECT_NEAR(double(errors[0].depth.size()), double(errors[1].depth.size()), 4);
    EXPECT_LT(quantile(errors[1].depth, 0.99), 0.01);
}

} // namespace
} // namespace isomotion::accuracy
