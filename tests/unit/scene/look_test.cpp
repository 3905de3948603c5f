// Looks: what a scene says itself wins, and what a look set is told.
#include "scene/data_folder.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class Looks : public Scenes {
protected:
    Looks() {
        std::filesystem::create_directories(folder() / "animations" / "looks");
        write("animations/looks/day.toml", R"toml(title = "Day"
[[lights]]
direction = [0, 0, 1]
[[lights]]
direction = [1, 0, 0]
[ambient]
top = [0.5, 0.5, 0.5]
[material]
color = [0.1, 0.2, 0.3]
model = "ggx"
roughness = 0.3
[output]
background = { top = [1, 1, 1], bottom = [0, 0, 0] }
samples = 4
)toml");
    }
};

const std::string day = "look = \"day\"\n";

TEST_F(Looks, SetWhatTheSceneDoesNotSay) {
    const Scene scene = loaded(day + ball());
    EXPECT_EQ(scene.surfaces[0].look.name, "day");
    EXPECT_THAT(scene.surfaces[0].look.keys,
                UnorderedElementsAre("lights", "ambient", "material", "output.background",
                                     "output.samples"));
    EXPECT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.surfaces[0].material.model, Material::Model::ggx);
    EXPECT_EQ(scene.output.samples, 4);
    EXPECT_TRUE(scene.output.gradient);
    EXPECT_EQ(scene.output.width, 64); // the scene's own
    EXPECT_EQ(at_time(scene, 0).surfaces[0].color, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(at_time(scene, 0).ambient.bottom, glm::dvec3(0.5));
}

TEST_F(Looks, GiveWayToTheScene) {
    const Scene scene = loaded(day + ball() +
                               "samples = 2\nbackground = [0, 1, 0]\n[material]\n"
                               "roughness = 0.7\n[[lights]]\ndirection = [0, 1, 0]");
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.output.samples, 2);
    EXPECT_FALSE(scene.output.gradient);
    EXPECT_EQ(at_time(scene, 0).surfaces[0].gloss.x, 0.7);
    EXPECT_THAT(scene.surfaces[0].look.keys,
                UnorderedElementsAre("ambient", "material.color", "material.model"));
}

// A roughness without its model would be a mistake of the look's.
TEST_F(Looks, AModelTakesItsValuesAlong) {
    const Scene scene = loaded(day + ball_and("[material]\nmodel = \"blinn-phong\""));
    EXPECT_EQ(scene.surfaces[0].material.model, Material::Model::blinn_phong);
    EXPECT_FALSE(scene.surfaces[0].material.roughness);
}

TEST_F(Looks, AreNamedOnTheCommandLine) {
    EXPECT_EQ(loaded(ball(), {"look=day"}).surfaces[0].look.name, "day");
    EXPECT_EQ(loaded(day + ball(), {"look=none"}).output.samples, 1);
    EXPECT_EQ(loaded(day + ball(), {"look=none"}).surfaces[0].look.name, "");
    EXPECT_THAT(loaded(ball(), {"look=none"}).surfaces[0].look.keys, IsEmpty());
    // A setting is the scene's own word.
    EXPECT_EQ(loaded(day + ball(), {"output.samples=2"}).output.samples, 2);
}

TEST_F(Looks, AParameterOfThatNameIsStillOne) {
    const Scene scene = load_text(ball_with(6, "formula = \"x^2 + y^2 + z^2 - radius*look\"") +
                                      "[parameters.look]\ndefault = 1",
                                  "scene.toml", {"look=1+t"});
    EXPECT_EQ(at_time(scene, 1).surfaces[0].bindings.parameters.at(0), 2);
}

TEST_F(Looks, ThatThereAreNotAreMistakes) {
    EXPECT_EQ(mistake("look = \"dya\"\n" + ball()),
              "scene.toml:1: look: there is no look 'dya'; did you mean 'day'? known: day, none");
    EXPECT_EQ(mistake("look = 3\n" + ball()),
              "scene.toml:1: look: must be a text in quotes, as \"studio\"");
}

// Moved into the scene's document, a look's values keep their place.
TEST_F(Looks, MistakesOfALookNameItsFile) {
    write("animations/looks/wrong.toml", "title = \"Wrong\"\n[material]\nmodel = \"plastic\"\n");
    EXPECT_THAT(mistake("look = \"wrong\"\n" + ball()),
                testing::StartsWith("animations/looks/wrong.toml:3: material.model: "));
}

TEST_F(Looks, TheWrittenSceneIsTheSame) {
    const std::string file = write("scene.toml", day + ball()).string();
    const std::string text = scene_file_text(file);
    const Scene before = load(file), after = load_text(text, "again.toml");
    const auto a = before.surfaces[0].animation.at(before.timeline.time(1)),
               b = after.surfaces[0].animation.at(after.timeline.time(1));
    EXPECT_EQ(a.tracks, b.tracks);
    EXPECT_EQ(after.output.samples, 4);
    EXPECT_EQ(after.surfaces[0].look.name, "");
}

TEST_F(Looks, AreLeftOutWhereAListOfSurfacesIsToBeWritten) {
    const std::string surface = "[[surfaces]]\nformula = 'x^2 + y^2 + z^2 - 1'\n";
    const std::string file = write("scene.toml", day + surface + surface).string();
    EXPECT_THROW(scene_file_text(file), SceneError);
    EXPECT_NO_THROW(load_text(scene_file_text(file, {"look=none"}), "again.toml"));
}

TEST(InstalledLooks, FitEveryScene) {
    for (const std::string& look : look_names()) {
        const Scene scene = load("x^2 + y^2 + z^2 = 1", {"look=" + look});
        EXPECT_EQ(scene.surfaces[0].look.name, look);
        EXPECT_EQ(scene.output.samples, 16) << look;
        at_frame(scene, 1);
        const Scene own = load("x^2 + y^2 + z^2 = 1",
                               {"look=" + look, "output.background=[0,0,0]", "material.model=ggx",
                                "environment.map=studio.exr", "material.roughness=0.5"});
        EXPECT_EQ(at_frame(own, 1).surfaces[0].gloss.x, 0.5) << look;
    }
}

} // namespace
} // namespace isomotion::scene
