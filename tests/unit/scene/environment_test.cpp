// The [environment] of a scene, and what is behind the surface without one.
#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::ElementsAre;

class EnvironmentSection : public Scenes {
protected:
    EnvironmentSection() {
        std::filesystem::create_directories(folder() / "media");
        write("sky.exr", "loading a scene reads no picture");
        write("media/studio.exr", "");
        write("media/sky.exr", "");
    }
    std::string with(const std::string& lines) const {
        return ball_and("[environment]\nmap = \"sky.exr\"\n" + lines);
    }
    glm::dvec3 ahead(const std::string& rotation, double time = 0) const {
        return at_time(loaded(with("rotation = " + rotation)), time).environment->ahead;
    }
};

TEST_F(EnvironmentSection, ASceneHasNone) {
    const Scene scene = loaded(ball());
    EXPECT_FALSE(scene.environment);
    EXPECT_FALSE(at_time(scene, 0).environment);
}

TEST_F(EnvironmentSection, MapsAreBesideTheSceneOrInMedia) {
    EXPECT_EQ(loaded(with("")).environment->map, folder() / "sky.exr");
    EXPECT_EQ(loaded(ball_and("[environment]\nmap = \"studio.exr\"")).environment->map,
              folder() / "media" / "studio.exr");
    EXPECT_EQ(loaded(ball_and("[environment]\nmap = \"media/studio.exr\"")).environment->map,
              folder() / "media" / "studio.exr");
    const std::string absolute = (folder() / "media" / "sky.exr").string();
    EXPECT_EQ(loaded(ball_and("[environment]\nmap = \"" + absolute + "\"")).environment->map,
              absolute);
}

TEST_F(EnvironmentSection, MapsOfTheCommandLineToo) {
    EXPECT_EQ(loaded(ball(), {"environment.map=studio.exr"}).environment->map,
              folder() / "media" / "studio.exr");
    EXPECT_EQ(mistake(with(""), {"environment.map=none.exr"}),
              "--set: environment.map: there is no file none.exr, nor media/none.exr");
}

TEST_F(EnvironmentSection, Defaults) {
    const Scene scene = loaded(with(""));
    EXPECT_TRUE(scene.environment->background);
    const EnvironmentAt now = *at_time(scene, 0).environment;
    EXPECT_EQ(now.ahead, glm::dvec3(1, 0, 0));
    EXPECT_EQ(now.left, glm::dvec3(0, 1, 0));
    EXPECT_EQ(now.top, glm::dvec3(0, 0, 1));
    EXPECT_EQ(now.intensity, 1);
}

TEST_F(EnvironmentSection, Moves) {
    const Scene scene = loaded(with("rotation = \"90*t\"\nintensity = \"2 + t\""));
    const EnvironmentAt now = *at_time(scene, 1).environment;
    EXPECT_LT(glm::length(now.ahead - glm::dvec3(0, 1, 0)), 1e-15);
    EXPECT_LT(glm::length(now.left - glm::dvec3(-1, 0, 0)), 1e-15);
    EXPECT_EQ(now.top, glm::dvec3(0, 0, 1));
    EXPECT_EQ(now.intensity, 3);
}

TEST_F(EnvironmentSection, WholeTurnsAreNone) {
    const glm::dvec3 third = ahead("120");
    EXPECT_EQ(ahead("\"120 - 3600000000\""), third);
    EXPECT_EQ(ahead("480"), third);
    EXPECT_EQ(ahead("-240"), third);
    EXPECT_EQ(ahead("\"360*t\"", 5), ahead("0"));
}

TEST_F(EnvironmentSection, TurnsWithTheSurfaceIntoFormulaCoordinates) {
    const Scene scene = loaded(ball_with(7, "bounds = { sphere = 1.5 }\n"
                                            "transform = { rotate = [0, 0, 90], scale = 2 }") +
                               "[environment]\nmap = \"sky.exr\"\n");
    const EnvironmentAt there = *in_formula_coordinates(at_time(scene, 0)).environment;
    EXPECT_LT(glm::length(there.ahead - glm::dvec3(0, -1, 0)), 1e-15);
    EXPECT_LT(glm::length(there.left - glm::dvec3(1, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(there.top - glm::dvec3(0, 0, 1)), 1e-15);
}

TEST_F(EnvironmentSection, AWrittenBackgroundGoesBeforeTheMap) {
    const std::string map = "[environment]\nmap = \"sky.exr\"\n";
    const std::string white = ball_with(14, "background = [1, 1, 1]");
    EXPECT_FALSE(loaded(white + map).environment->background);
    EXPECT_FALSE(loaded(white + map + "background = false").environment->background);
    EXPECT_FALSE(loaded(with("background = false")).environment->background);
    EXPECT_TRUE(loaded(with("background = true")).environment->background);
    EXPECT_EQ(mistake(white + map + "background = true"),
              "scene.toml:17: environment.background: the scene has output.background already; "
              "keep one");
}

TEST_F(EnvironmentSection, Mistakes) {
    const std::vector<Mistake> mistakes = {
        {ball_and("[environment]\nrotation = 3"),
         "scene.toml:15: environment: needs map = \"FILE\", a latitude-longitude map such as "
         "\"studio.exr\""},
        {ball_and("[environment]\nmap = 3"),
         "scene.toml:16: environment.map: must be a text in quotes"},
        {ball_and("[environment]\nmap = \"none.exr\""),
         "scene.toml:16: environment.map: there is no file none.exr, nor media/none.exr"},
        {ball_and("[environment]\nmap = \"\""),
         "scene.toml:16: environment.map: there is no file , nor media/"},
        {ball_and("[environment]\nmap = \"media\""),
         "scene.toml:16: environment.map: there is no file media, nor media/media"},
        {with("background = 1"), "scene.toml:17: environment.background: must be true or false"},
        {with("rotatoin = 1"),
         "scene.toml:17: environment.rotatoin: unknown key; did you mean 'rotation'?"},
        {with("intensity = inf"), "scene.toml:17: environment.intensity: must be finite"},
        {with("intensity = \"2*u\""),
         "scene.toml:17: environment.intensity: unknown name 'u'; known: t, radius, pi\n    2*u\n"
         "      ^"},
        {ball() + "environment = \"sky.exr\"", "scene.toml:15: output.environment: unknown key; "
                                               "known here: background, poster, samples, size"},
        {"environment = \"sky.exr\"\n" + ball(),
         "scene.toml:1: environment: must be a table: [environment]"},
    };
    for (const auto& [text, message] : mistakes) EXPECT_EQ(mistake(text), message) << text;
    EXPECT_EQ(mistake(with("intensity = -1")),
              "scene.toml:17: environment.intensity at t = 0: must be from 0 to 1000000, not -1");
    EXPECT_EQ(mistake(with("rotation = \"log(t - 1)\"")),
              "scene.toml:17: environment.rotation at t = 0: the value is not a number");
}

class Gradient : public Scenes {};

TEST_F(Gradient, HasTwoColours) {
    const Scene scene =
        loaded(ball_with(14, "background = { top = [0, 0.5, 1], bottom = [2, 0, 0] }"));
    ASSERT_TRUE(scene.output.gradient);
    EXPECT_THAT(scene.output.gradient->top, ElementsAre(0, 0.5, 1));
    EXPECT_THAT(scene.output.gradient->bottom, ElementsAre(2, 0, 0));
    EXPECT_FALSE(scene.output.transparent);
    EXPECT_FALSE(loaded(ball()).output.gradient);
}

TEST_F(Gradient, Mistakes) {
    const auto expect = [&](const std::string& value, const std::string& message) {
        EXPECT_EQ(mistake(ball_with(14, "background = " + value)),
                  "scene.toml:14: output.background" + message);
    };
    expect("{ top = [0, 0, 0] }", ".bottom: is missing; give [r, g, b]");
    expect("{ bottom = [0, 0, 0] }", ".top: is missing; give [r, g, b]");
    expect("{}", ".top: is missing; give [r, g, b]\n"
                 "scene.toml:14: output.background.bottom: is missing; give [r, g, b]");
    expect("{ top = [0, 0], bottom = [0, 0, 0] }", ".top: must be [r, g, b] (linear)");
    expect("{ top = \"t\", bottom = [0, 0, 0] }", ".top: must be [r, g, b] (linear)");
    expect("{ top = [0, 0, nan], bottom = [0, 0, 0] }", ".top: must be finite");
    expect("{ top = [0, 0, 0], botom = [0, 0, 0] }",
           ".bottom: is missing; give [r, g, b]\n"
           "scene.toml:14: output.background.botom: unknown key; did you mean 'bottom'?");
    expect("{ top = [0, 0, 0], bottom = [0, 0, 0], middle = [0, 0, 0] }",
           ".middle: unknown key; known here: bottom, top");
}

} // namespace
} // namespace isomotion::scene
