// What a page refuses, and what its passes are.
#include "page/web_scene.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "page/description.h"
#include "page/frame_values.h"
#include "scene/error.h"
#include "scene/reading/load.h"
#include "shader/assemble.h"
#include "shader/beam_copies_text.h"
#include "shader/inlined_size.h"

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
    EXPECT_THAT(refusal(balls(most_elements_by_place + 1)),
                AllOf(StartsWith("page.toml:5: arrays.b.count: the array has 20001 elements"),
                      HasSubstr("20000"), HasSubstr("isomotion render --movie")));
    EXPECT_EQ(refusal(balls(5000)), "");
    // Fewer fit into a scene that asks for all elements at every place.
    const std::string all = "[isolation]\nbeam = false\n";
    EXPECT_THAT(refusal(balls(most_elements + 1) + all),
                AllOf(StartsWith("page.toml:5: arrays.b.count: "), HasSubstr("have 1001 elements"),
                      HasSubstr("1000")));
    EXPECT_EQ(refusal(balls(most_elements) + all), "");
}

TEST(WebScene, IsOfGlslEsWithoutListsProofsOrBuffers) {
    const WebScene web = web_scene(scene_of(balls(900) + "[isolation]\ncertify = true\n"));
    EXPECT_FALSE(web.surfaces[0].passes.has(shader::Role::proof));
    ASSERT_FALSE(web.surfaces[0].passes.list.empty());
    for (const shader::Pass& pass : web.surfaces[0].passes.list) {
        SCOPED_TRACE(pass.name);
        EXPECT_THAT(pass.text, StartsWith("#version 300 es\n"));
        EXPECT_THAT(pass.vertex, StartsWith("#version 300 es\n"));
        EXPECT_THAT(pass.text, Not(HasSubstr("uniform samplerBuffer")));
        EXPECT_THAT(pass.text, Not(HasSubstr("std430")));
    }
}

constexpr const char* two_surfaces =
    "[[surfaces]]\nname = 'ball'\nformula = 'x^2 + y^2 + z^2 - r^2'\nbounds = { sphere = 2 }\n"
    "parameters = { r = '1 + 0.1*t' }\n"
    "[[surfaces]]\nname = 'box'\nformula = 'max(abs(x), abs(y), abs(z)) - r'\n"
    "parameters = { r = 0.8 }\nbounds = { sphere = 1.5 }\n"
    "transform = { translate = ['t', 0, 0] }\n[time]\nframes = 5\n";

scene::Scene several(const std::string& more = "") {
    return scene::load_text(two_surfaces + more, "page.toml");
}

TEST(WebScene, OfSeveralSurfacesHasThePassesOfEach) {
    using shader::Role;
    const WebScene plain = web_scene(several());
    ASSERT_EQ(plain.surfaces.size(), 2u);
    EXPECT_EQ(plain.scene->surfaces.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        const WebSurface& surface = plain.surfaces[k];
        EXPECT_EQ(surface.one.index, k);
        EXPECT_EQ(&surface.one.scene, plain.scene.get());
        EXPECT_TRUE(surface.passes.has(Role::fused));
        EXPECT_THAT(surface.passes.at(Role::fused).text, HasSubstr("surface_way"));
    }
    EXPECT_NE(plain.surfaces[0].passes.fingerprint(), plain.surfaces[1].passes.fingerprint());
    const WebScene lit = web_scene(several("[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n"));
    for (const WebSurface& surface : lit.surfaces) {
        EXPECT_FALSE(surface.passes.has(Role::fused));
        EXPECT_TRUE(surface.passes.has(Role::shadow));
    }
}

// One that takes more than a draw has others drawn in passes, too.
TEST(WebScene, SurfacesAreAllDrawnInOneDrawEachOrNone) {
    using shader::Role;
    scene::Scene scene = several();
    scene.surfaces[1].material.model = scene::Material::Model::ggx;
    const WebScene web = web_scene(std::move(scene));
    for (const WebSurface& surface : web.surfaces) EXPECT_FALSE(surface.passes.has(Role::fused));
}

TEST(WebScene, RefusesGlassAmongSeveralSurfaces) {
    try {
        web_scene(scene::load_text(std::string(two_surfaces)
                                       .replace(std::string_view(two_surfaces).find("[time]"), 0,
                                                "material = { transmission = 1 }\n"),
                                   "page.toml"));
        FAIL() << "nothing was thrown";
    } catch (const scene::SceneError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(StartsWith("page.toml:12: surfaces.box.material.transmission: "),
                          HasSubstr("one surface alone")));
    }
    const WebScene alone = web_scene(scene_of("formula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere "
                                              "= 2 }\n[material]\ntransmission = 1\n"));
    EXPECT_TRUE(alone.surfaces[0].passes.has(shader::Role::glass));
}

TEST(FrameValues, OfSeveralSurfacesHaveTheirRowsAndOneCamera) {
    const WebScene web = web_scene(several());
    const FrameValues values = frame_values(web);
    ASSERT_EQ(values.size(), 2u);
    for (const ValueTable* table : values[1].tables()) EXPECT_EQ(table->rows(), 5u);
    const auto has = [](const SurfaceValues& of, const std::string& name) {
        return std::ranges::count(of.view_places, name, &Place::name) == 1;
    };
    EXPECT_TRUE(has(values[0], "position") && has(values[0], "translate"));
    EXPECT_TRUE(!has(values[1], "position") && has(values[1], "translate"));
    EXPECT_EQ(values[0].parameters.moving(), 1u) << "r of the ball";
    EXPECT_EQ(values[1].parameters.moving(), 0u);
    EXPECT_EQ(values[0].view.moving(), 0u);
    EXPECT_EQ(values[1].view.moving(), 2u) << "the two words of a double";
}

TEST(Description, NamesSlidersBySurfaceWhereThereAreSeveral) {
    const auto names_of = [](scene::Scene scene) {
        const WebScene web = web_scene(std::move(scene));
        const auto all = nlohmann::json::parse(description(web, frame_values(web), nullptr, {}));
        std::vector<std::string> names;
        for (const auto& slider : all["sliders"]) {
            names.push_back(slider["name"].get<std::string>() + " of " +
                            std::to_string(slider["surface"].get<int>()));
        }
        return names;
    };
    EXPECT_THAT(names_of(several()), testing::ElementsAre("ball/r of 0", "box/r of 1"));
    EXPECT_THAT(names_of(scene_of("formula = 'x^2 + y^2 + z^2 - r'\nbounds = { sphere = 2 }\n"
                                  "[parameters]\nr = 1\n")),
                testing::ElementsAre("r of 0"));
}

// What lies beside a scene with several surfaces is of one of them.
TEST(Description, ReadsNoTimelineOfSeveralSurfaces) {
    const auto folder = std::filesystem::path(testing::TempDir());
    std::ofstream(folder / "beside.timeline.json") << "{}";
    const auto warnings_of = [&](const std::string& text) {
        const WebScene web = web_scene(scene::load_text(text, (folder / "beside.toml").string()));
        std::vector<std::string> warnings;
        PageOptions options;
        options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
        description(web, frame_values(web), nullptr, options);
        return warnings;
    };
    EXPECT_THAT(
        warnings_of("[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 2 }\n"),
        testing::SizeIs(1));
    EXPECT_THAT(warnings_of(two_surfaces), testing::IsEmpty());
}

// Beams tell which elements matter, and a pass copies those, where all rays begin at the eye.
TEST(WebScene, UpTo384ElementsAreCopiedToListsOfBeams) {
    using shader::Role;
    for (const int count : {9, 32, 33, 75, 129, 384}) {
        SCOPED_TRACE(count);
        const shader::Passes passes = web_scene(scene_of(balls(count))).surfaces[0].passes;
        EXPECT_TRUE(shader::has_copies(passes));
        EXPECT_FALSE(shader::array_with_grid(passes));
        // From many elements on in three levels, as `render` finds them.
        ASSERT_EQ(passes.beams.size(), count <= 32 ? 2u : 3u);
        const int last = int(passes.beams.size()) - 1;
        // A beam and its bits are drawn at once; browsers have 8 textures for that, of which WebGL2
        // promises 4.
        const int texels = (count + 127) / 128;
        EXPECT_EQ(shader::masks_of_level(passes, passes.beams.back()), texels);
        const auto reads = [&](Role role, int level) {
            const std::vector<std::string>& samplers = passes.at(role, level).samplers;
            return std::ranges::count(samplers, "array0_lists") == 1;
        };
        for (int level = 0; level < last; ++level) {
            EXPECT_EQ(shader::masks_of_level(passes, passes.beams[std::size_t(level)]), 2 * texels);
        }
        for (const Role role : {Role::beams, Role::beam_copies}) {
            EXPECT_FALSE(reads(role, 0)) << "these go through all";
            for (int level = 1; level <= last; ++level) EXPECT_TRUE(reads(role, level)) << level;
        }
        for (const Role role : {Role::fused, Role::march}) EXPECT_TRUE(reads(role, 0));
    }
    for (const std::string& scene :
         {balls(8), balls(385), balls(75) + "[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n"})
        EXPECT_FALSE(shader::has_copies(web_scene(scene_of(scene)).surfaces[0].passes)) << scene;
}

// Rows of 16 elements, the last place of a list for its length.
TEST(WebScene, ListsOfTheFirstBeamsHaveRoomForAllElements) {
    for (const int count : {9, 15, 16, 75, 383, 384}) {
        SCOPED_TRACE(count);
        const shader::Passes passes = web_scene(scene_of(balls(count))).surfaces[0].passes;
        const int texels = passes.arrays[0].texels;
        EXPECT_GE(rows_of_copies(passes, 0) * 16 / texels, count + 1);
        EXPECT_LT(rows_of_copies(passes, 0) * 16 / texels, count + 17);
    }
}

// So many Gaussian balls whose elements have so many texels, each of four fields.
std::string balls_of_texels(int count, int texels) {
    std::string factors = "1", fields;
    for (int k = 3; k < 4 * texels; ++k) {
        factors += fmt::format("*f{}", k);
        fields += fmt::format("f{} = '1 + 0.01*random(i, {})'\n", k, k);
    }
    return fmt::format("formula = 'sum(p, {}*exp(-20*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - "
                       "0.5'\nbounds = {{ sphere = 2 }}\n[isolation]\nmethod = 'hermite'\n"
                       "[arrays.p]\ncount = {}\ncx = 'random(i, 0)'\ncy = 'random(i, 1)'\n"
                       "cz = 'random(i, 2)'\n{}",
                       factors, count, fields);
}

// WebGL2 promises textures of 2048 pixels across: all lists of a tile fit.
TEST(WebScene, ListsFitIntoTheTexturesThatEveryBrowserHas) {
    for (const auto& [count, texels] :
         {std::pair{9, 1}, std::pair{128, 1}, std::pair{129, 1}, std::pair{384, 1},
          std::pair{384, 2}, std::pair{384, 3}, std::pair{384, 4}, std::pair{128, 5}}) {
        SCOPED_TRACE(fmt::format("{} elements of {} texels", count, texels));
        const WebScene web = web_scene(scene_of(balls_of_texels(count, texels)));
        const shader::Passes& passes = web.surfaces[0].passes;
        ASSERT_EQ(passes.arrays[0].texels, texels);
        ASSERT_TRUE(shader::has_copies(passes));
        int rows = 0;
        for (std::size_t level = 0; level < passes.beams.size(); ++level) {
            const shader::BeamLevel& beam = passes.beams[level];
            const int across =
                (web.surfaces[0].plan.march.tile_width + beam.block - 1) / beam.block;
            EXPECT_LE(16 * lists_of_a_block(beam) * across, 2048);
            rows += rows_of_copies(passes, int(level)) * across;
        }
        EXPECT_LE(rows, 2048);
    }
}

// And where they don't, rays find elements by place, which needs no such texture.
TEST(WebScene, ListsThatWouldNotFitAreNotMade) {
    using shader::Role;
    for (const auto& [count, texels] : {std::pair{100, 8}, std::pair{384, 6}, std::pair{128, 12}}) {
        SCOPED_TRACE(fmt::format("{} elements of {} texels", count, texels));
        const shader::Passes passes =
            web_scene(scene_of(balls_of_texels(count, texels))).surfaces[0].passes;
        EXPECT_TRUE(shader::array_with_grid(passes) || shader::copies_fit(passes));
        EXPECT_EQ(passes.has(Role::beam_copies), shader::has_copies(passes));
        for (const shader::BeamLevel& level : passes.beams)
            EXPECT_EQ(level.lists != shader::BeamLists::none, shader::has_copies(passes));
    }
    EXPECT_FALSE(
        shader::has_copies(web_scene(scene_of(balls_of_texels(384, 12))).surfaces[0].passes));
}

// A page that keeps no lists has fewer operations than `render` would compile.
TEST(WebScene, IsRefusedByTheLengthOfItsOwnShaders) {
    const scene::Scene scene = scene_of(balls_of_texels(12, 60));
    const double largest = shader::largest_shaders();
    EXPECT_GT(shader::assemble(scene).size_compiled, largest);
    EXPECT_LT(shader::inlined_size(web_scene(scene).surfaces[0].passes), largest);
    std::string waves = "x";
    for (int k = 1; k < 700; ++k) waves += fmt::format("*(1 + 0.01*sin({}*y)*cos({}.5*z))", k, k);
    const std::string text = fmt::format("formula = '{}'\nbounds = {{ sphere = 2 }}\n", waves);
    EXPECT_THROW(web_scene(scene_of(text)), std::length_error);
}

TEST(FrameValues, RefuseTooMuchOfThem) {
    const WebScene web = web_scene(scene_of(balls(90) + "[time]\nframes = 250000\n"));
    try {
        frame_values(web);
        FAIL() << "nothing was thrown";
    } catch (const scene::SceneError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("the values of 250000 frames are 9"),
                                        HasSubstr("at most 32"), HasSubstr("time.frames")));
    }
}

TEST(FrameValues, OfManyFramesTakeLittleWhereLittleMoves) {
    const std::string sphere = "formula = 'x^2 + y^2 + z^2 - r'\nbounds = { sphere = 2 }\n"
                               "[parameters]\nr = '1 + 0.001*sin(t)'\n[time]\nframes = 20000\n";
    const FrameValues values = frame_values(web_scene(scene_of(sphere)));
    std::size_t moving = 0;
    for (const ValueTable* table : values[0].tables()) moving += table->moving();
    EXPECT_EQ(moving, 1u);
}

TEST(FrameValues, HaveARowForEachMomentOfMotionBlur) {
    const std::string scene = balls(3) + "[time]\nframes = 5\nfps = 10\n[camera]\nshutter = 0.5\n";
    const WebScene web = web_scene(scene_of(scene + "[output]\nsamples = 4\n"));
    EXPECT_THAT(moments(*web.scene), testing::ElementsAre(0, 0.125, 0.25, 0.375));
    EXPECT_EQ(frame_values(web)[0].view.rows(), 20u);
    EXPECT_THAT(moments(scene_of(balls(3))), testing::ElementsAre(0));
}

TEST(FrameValues, HaveAGridOfElementsThatAreFoundByPlace) {
    const WebScene web = web_scene(scene_of(balls(400) + "[time]\nframes = 2\n"));
    ASSERT_TRUE(shader::array_with_grid(web.surfaces[0].passes));
    EXPECT_FALSE(frame_values(web)[0].grids.empty());
    EXPECT_TRUE(frame_values(web_scene(scene_of(balls(20))))[0].grids.empty());
}

TEST(FrameValues, AreARowAFrameAndAsLongAsTheShadersRead) {
    const WebScene web = web_scene(scene_of(balls(10) + "[time]\nframes = 7\n"));
    const FrameValues values = frame_values(web);
    for (const ValueTable* table : values[0].tables())
        EXPECT_EQ(table->rows(), 7u) << table->name();
    ASSERT_EQ(values[0].arrays.size(), 1u);
    EXPECT_EQ(values[0].arrays[0].width(),
              std::size_t(4 * 10 * web.surfaces[0].passes.arrays[0].texels));
    EXPECT_EQ(values[0].parameters.width(), std::size_t(4 * web.surfaces[0].passes.vectors()));
    std::size_t numbers = 0;
    for (const Place& place : values[0].view_places) numbers += std::size_t(place.count);
    EXPECT_EQ(values[0].view.width(), 2 * numbers);
}

} // namespace
} // namespace isomotion::page
