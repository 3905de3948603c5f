// A renderer that is resized or adjusted draws what one made so would.
#include "drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

class Resize : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Resize);

Picture drawn_small_tiled(gpu::Context& context, const scene::Scene& scene, int frame) {
    RenderOptions options{128, 128, every_channel, {}};
    options.pixels = std::int64_t(scene.output.width) * scene.output.height;
    Renderer renderer(context, scene, options);
    const scene::SceneAt now = scene::at_frame(scene, frame);
    renderer.resize(40, 30);
    renderer.draw(now);
    renderer.resize(scene.output.width, scene.output.height);
    return renderer.draw(now);
}

// Lists of elements, beams and a plain formula; sizes that tiles of 128 do not divide.
TEST_P(Resize, DrawsWhatARendererOfThatSizeDraws) {
    for (const char* name : {"blobby75", "barth_sextic", "superquadric"}) {
        const scene::Scene scene = scene::load(name, {"look=none", "output.size=[200,150]"});
        const Picture whole = draw(*context, scene, 40);
        const Picture tiled = drawn_small_tiled(*context, scene, 40);
        EXPECT_GT(count(whole, Verdict::hit), 1000) << name;
        EXPECT_TRUE(same_bits(whole.frame, tiled.frame)) << name;
        EXPECT_EQ(whole.verdicts, tiled.verdicts) << name;
        EXPECT_EQ(whole.evaluations(), tiled.evaluations()) << name;
    }
}

TEST_P(Resize, RefusesTilesThatWouldCutOtherBlocks) {
    const scene::Scene scene = scene_of(sphere_scene);
    Renderer renderer(*context, scene, {100, 100, {}, {}});
    EXPECT_NO_THROW(renderer.resize(64, 100));
    EXPECT_THROW(renderer.resize(101, 100), std::invalid_argument);
    EXPECT_THROW(renderer.resize(0, 100), std::invalid_argument);
}

TEST_P(Resize, AdjustedSettingsAreTheScenesOwn) {
    const std::string method = "isolation.method=\"amp-sign\"";
    const scene::Scene coarse = scene_of(sphere_scene, {method, "isolation.step=0.5"});
    const scene::Scene fine = scene_of(sphere_scene, {method, "isolation.step=0.01"});
    const scene::SceneAt now = scene::at_frame(coarse, 1);
    Renderer renderer(*context, coarse, {160, 120, every_channel, {}});
    const Picture before = renderer.draw(now);
    renderer.adjust(fine.surfaces[0].isolation);
    const Picture after = renderer.draw(now);
    EXPECT_GT(after.evaluations(), 4 * before.evaluations());
    EXPECT_TRUE(same_bits(after.frame, draw(*context, fine).frame));
    scene::Isolation other = fine.surfaces[0].isolation;
    other.method = scene::Method::marching;
    EXPECT_THROW(renderer.adjust(other), std::invalid_argument);
}

// Settings of several surfaces change alike.
TEST_P(Resize, AdjustedSettingsAreThoseOfEachSurface) {
    const auto scene_with = [](double step, double other) {
        std::string text;
        for (const auto& [x, its] : {std::pair{-1, step}, {1, other}})
            text += fmt::format(
                "[[surfaces]]\nformula = 'x^2 + y^2 + z^2 - 0.25'\n"
                "bounds = {{ sphere = 0.55 }}\ntransform = {{ translate = [{}, 0, 0] }}\n"
                "isolation = {{ method = 'marching', step = {} }}\n",
                x, its);
        return scene_of(text + "[camera]\nposition = [0, -6, 1]\n[output]\nsize = [64, 64]\n");
    };
    const scene::Scene fine = scene_with(0.01, 0.02), coarse = scene_with(0.04, 0.08);
    const auto renderer_of = [&](const scene::Scene& scene) {
        return Renderer(*context, scene, {64, 64, {shader::Channel::surface}, {}});
    };
    const auto evaluations = [](Renderer& renderer, const scene::Scene& scene) {
        return renderer.draw(scene::at_frame(scene, 1)).evaluations();
    };
    Renderer adjusted = renderer_of(fine), anew = renderer_of(coarse);
    const auto before = evaluations(adjusted, fine);
    adjusted.adjust(coarse.surfaces[0].isolation);
    const auto after = evaluations(adjusted, fine);
    EXPECT_LT(after, before);
    EXPECT_EQ(after, evaluations(anew, coarse));
    adjusted.adjust(fine.surfaces[0].isolation);
    EXPECT_EQ(evaluations(adjusted, fine), before);
}

TEST_P(Resize, APictureThatIsGivenUpLeavesTheRendererWhole) {
    const scene::Scene scene = scene_of(sphere_scene);
    int tiles = 0;
    bool stops = true;
    RenderOptions options{64, 64, every_channel, {}};
    options.stop = [&] { return ++tiles > 2 && stops; };
    Renderer renderer(*context, scene, options);
    renderer.resize(scene.output.width, scene.output.height);
    const scene::SceneAt now = scene::at_frame(scene, 1);
    EXPECT_THROW(renderer.draw(now), Stopped);
    EXPECT_EQ(tiles, 3);
    stops = false;
    EXPECT_TRUE(same_bits(renderer.draw(now).frame, draw(*context, scene).frame));
}

} // namespace
} // namespace isomotion::render
