// A scene's document written as a scene file.
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "scene/data_folder.h"
#include "scene/reading/load.h"
#include "scene/reading/scene_text.h"
#include "scene/scene_at.h"

namespace isomotion::scene {
namespace {

TEST(SceneFileText, OfAFormulaSaysEverythingThatTheFormulaIs) {
    const std::string text = R"toml(title = "x^2 + y^2 + z^2 = a + 0.3*sin(9*x + t)"

[time]
fps = 30
frames = 120

[surface]
bounds = { sphere = 1.3 }
formula = "x^2 + y^2 + z^2 = a + 0.3*sin(9*x + t)"

[parameters]
a = 1.1
)toml";
    EXPECT_EQ(scene_file_text("x^2 + y^2 + z^2 = a + 0.3*sin(9*x + t)", {"a=1.1"}), text);
}

TEST(FormulaScene, HasTheBeginningOfALongFormulaAsItsTitle) {
    std::string formula = "x^2 + y^2\n  + z^2 = 1";
    EXPECT_EQ(load(formula).title, "x^2 + y^2 + z^2 = 1");
    for (int k = 0; k < 300; ++k) formula += " + 0*x";
    const std::string title = load(formula).title;
    EXPECT_LT(title.size(), 210u);
    EXPECT_THAT(title, testing::StartsWith("x^2 + y^2 + z^2 = 1 + 0*x"));
    EXPECT_THAT(title, testing::EndsWith("..."));
}

// t is the time wherever a formula may have it.
TEST(FormulaScene, FindsTheTimeInAFormula) {
    for (const char* formula : {"x^2 + y^2 + z^2 = 1 + 0.1*sin(2t)", "x^2+y^2+z^2=1+2.5e-1t",
                                "x^2 + y^2 + z^2 = t", "x^2 + y^2 + z^2 = 1 + 0.1(t)"}) {
        const Scene scene = load(formula);
        EXPECT_EQ(scene.timeline.frames, 120) << formula;
        EXPECT_EQ(scene.surfaces[0].animation.at(scene.timeline.time(31)).tracks[0], 1)
            << formula; // a second
    }
    EXPECT_EQ(load("x^2 + y^2 + z^2 = 1e3").timeline.frames, 1);
    const Scene both = load("x^2 + y^2 + z^2 = 1 + t^2 + time", {"time=0.25"});
    std::vector<double> values = both.surfaces[0].animation.at(both.timeline.time(31)).tracks;
    values.resize(2); // what comes after is the camera's
    EXPECT_EQ(both.timeline.frames, 120);
    EXPECT_THAT(values, testing::UnorderedElementsAre(0.25, 1));
}

// Every section of a scene is written, of several surfaces with the bounds that were found.
TEST(SceneFileText, HasAllSections) {
    const std::string scene = R"toml(title = "All"

[[surfaces]]
formula = "x^2 + y^2 + z^2 - r"

[parameters]
r = 2.0

[camera]
zoom = 2.0

[[lights]]
direction = [0, 0, 1]

[[sections]]
normal = [0, 0, 1]

[fog]
density = 0.5
)toml";
    const auto file = std::filesystem::temp_directory_path() /
                      fmt::format("isomotion-all-sections-{}.toml", getpid());
    std::ofstream(file) << scene;
    std::string text = scene_file_text(file.string());
    std::filesystem::remove(file);
    const std::size_t begin = text.find("bounds = { sphere = "), end = text.find('\n', begin);
    ASSERT_NE(begin, text.npos) << text;
    EXPECT_EQ(text.erase(begin, end + 1 - begin), scene);
}

// Scenes of formulas and of the gallery have the same text and values when they are read again.
TEST(SceneFileText, IsReadAgainAsTheSameScene) {
    for (const char* name : {"x^2/4 + (y-1)^2 + z^2 = 1 + 0.1*sin(t)", "z = x*y", "blobby75",
                             "torus", "barth_sextic"}) {
        const std::string text = scene_file_text(name);
        const Scene before = load(name), after = load_text(text, "again.toml");
        EXPECT_EQ(after.title, before.title);
        EXPECT_EQ(after.timeline.frames, before.timeline.frames);
        EXPECT_EQ(after.surfaces[0].field->text, before.surfaces[0].field->text);
        for (const int frame : {1, 7}) {
            const SurfaceAt a = at_frame(before, frame).surfaces[0],
                            b = at_frame(after, frame).surfaces[0];
            EXPECT_EQ(a.values->tracks, b.values->tracks) << name;
            EXPECT_EQ(a.bounds.radius, b.bounds.radius);
            EXPECT_EQ(a.bounds.centre, b.bounds.centre);
        }
    }
}

TEST(SceneFileText, KeepsTextsAndNumbersToTheBit) {
    const toml::table root = toml::parse(R"toml(
title = "a \"quoted\" \\ and a tab\t"
[parameters]
third = 0.3333333333333333
one = 1.0
many = 123456789
"odd key" = { keys = [[0, 1e-30], [1.5, -2]], ease = "smooth" }
[arrays.p]
count = 2
cx = [0.1, 2.0]
[arrays.q]
count = 0
[[lights]]
shadow = true
[[lights]]
direction = [1, 0, "t"]
)toml");
    EXPECT_EQ(toml::parse(scene_text(root)), root);
}

} // namespace
} // namespace isomotion::scene
