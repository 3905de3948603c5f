// What a page refuses, and what its passes are.
#include "page/web_scene.h"

#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "page/frame_values.h"
#include "scene/error.h"
#include "scene/reading/load.h"

namespace isomotion::page {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

scene::Scene scene_of(const std::string& text) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    return scene::load_text("[surface]\n" + text, "page.toml");
}

std::string balls(int count) {
    return fmt::format("formula = 'sum(b, exp(-9*((x-cx)^2 + y^2 + z^2))) - 1'\n"
                       "bounds = {{ sphere = 2 }}\n[arrays.b]\ncount = {}\ncx = 'sin(i + t)'\n",
                       count);
}

std::string refusal(const std::string& text) {
    try {
        web_scene(scene_of(text));
    } catch (const scene::SceneError& error) {
        return error.what();
    }
    return "";
}

TEST(WebScene, RefusesTooManyElementsAndSaysHowManyFit) {
    EXPECT_THAT(refusal(balls(5000)),
                AllOf(StartsWith("page.toml: arrays have 5000 elements"), HasSubstr("1000"),
                      HasSubstr("isomotion render --movie")));
    EXPECT_EQ(refusal(balls(most_elements)), "");
}

TEST(WebScene, RefusesTooMuchData) {
    EXPECT_THAT(refusal(balls(1000) + "[time]\nframes = 25000\n"),
                AllOf(HasSubstr("the values of 25000 frames are 103 MB"), HasSubstr("at most 32"),
                      HasSubstr("time.frames")));
}

TEST(WebScene, RefusesMotionBlurWithTheKeyThatCallsItOff) {
    const std::string scene = "formula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 2 }\n"
                              "[output]\nsamples = 4\n[camera]\nshutter = ";
    EXPECT_THAT(refusal(scene + "0.5\n"), HasSubstr("--set camera.shutter=0"));
    EXPECT_EQ(refusal(scene + "0\n"), "");
}

TEST(WebScene, IsOfGlslEsWithoutListsProofsOrBuffers) {
    const WebScene web = web_scene(scene_of(balls(900) + "[isolation]\ncertify = true\n"));
    EXPECT_FALSE(web.passes.has(synthesis::Role::proof));
    ASSERT_FALSE(web.passes.list.empty());
    for (const synthesis::Pass& pass : web.passes.list) {
        SCOPED_TRACE(pass.name);
        EXPECT_THAT(pass.text, StartsWith("#version 300 es\n"));
        EXPECT_THAT(pass.vertex, StartsWith("#version 300 es\n"));
        EXPECT_THAT(pass.text, Not(HasSubstr("uniform samplerBuffer")));
        EXPECT_THAT(pass.text, Not(HasSubstr("std430")));
    }
}

TEST(FrameValues, AreARowAFrameAndAsLongAsTheShadersRead) {
    const WebScene web = web_scene(scene_of(balls(10) + "[time]\nframes = 7\n"));
    const FrameValues values = frame_values(web);
    for (const ValueTable* table : values.tables()) EXPECT_EQ(table->rows(), 7u) << table->name();
    ASSERT_EQ(values.arrays.size(), 1u);
    EXPECT_EQ(values.arrays[0].width(), std::size_t(4 * 10 * web.passes.arrays[0].texels));
    EXPECT_EQ(values.parameters.width(), std::size_t(4 * web.passes.vectors()));
    std::size_t numbers = 0;
    for (const Place& place : values.view_places) numbers += std::size_t(place.count);
    EXPECT_EQ(values.view.width(), 2 * numbers);
}

} // namespace
} // namespace isomotion::page
