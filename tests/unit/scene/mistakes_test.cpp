// A scene with several mistakes: all are told, by line, and none that only follows from another.
#include "testing.h"

namespace isomotion::scene {
namespace {

class SeveralMistakes : public Scenes {};

TEST_F(SeveralMistakes, AreToldTogetherByLine) {
    const std::string scene = R"toml(titel = "x"
[surface]
formula = "x^2 + y^2 + z^2 = r^2"
[parameters]
r = "1 + sin(tt)"
[camera]
fob = 40
position = [1, 2]
[[lights]]
direction = [1, 0.4, 1.2]
shadow = "yes"
[output]
size = 480
)toml";
    EXPECT_EQ(mistake(scene),
              "scene.toml:1: titel: unknown key; did you mean 'title'?\n"
              "scene.toml:5: parameters.r: unknown name 'tt'; did you mean 't'?\n"
              "    1 + sin(tt)\n"
              "            ^\n"
              "scene.toml:7: camera.fob: unknown key; did you mean 'fov'?\n"
              "scene.toml:8: camera.position: must have three components: [x, y, z]\n"
              "scene.toml:11: lights[0].shadow: must be true or false\n"
              "scene.toml:13: output.size: must be [width, height], integers from 1 to 16384");
}

TEST_F(SeveralMistakes, OneThatFollowsFromAnotherIsNotTold) {
    // The formula names r, the poster is a frame, and roughness is of a model.
    EXPECT_EQ(
        mistake("[surface]\nformula = \"x = r\"\n[parameters]\nr = true\n"),
        "scene.toml:4: parameters.r: must be a number, an expression in t (\"2 + sin(t)\"), or "
        "{ keys = [[t, value], ...], ease = \"smooth\" }");
    EXPECT_EQ(
        mistake("[surface]\nformula = \"x\"\n[time]\nframes = \"many\"\n[output]\nposter = 9\n"),
        "scene.toml:4: time.frames: must be an integer");
    EXPECT_EQ(mistake("[surface]\nformula = \"x\"\n[material]\nmodel = \"gx\"\nroughness = 0.2\n"),
              "scene.toml:4: material.model: there is no model 'gx'; did you mean 'ggx'? known: "
              "lambert, blinn-phong, ggx");
    EXPECT_EQ(mistake("[surface]\nformla = \"x\"\n"),
              "scene.toml:1: surface: needs formula = \"...\", or use = \"name\" of the catalogue");
}

// A light that is wrong as a whole leaves the others their numbers.
TEST_F(SeveralMistakes, OfAListKeepTheirNumbers) {
    const std::string words = mistake("[surface]\nformula = \"x\"\nbounds = { sphere = 1 }\n"
                                      "[[lights]]\ncolor = [1, 1, 1]\n"
                                      "[[lights]]\ncolor = [1, 1, 1]\n"
                                      "[[lights]]\ndirection = [0, 0, 1]\nshadow = 3\n");
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:4: lights[0]: "));
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:6: lights[1]: "));
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:10: lights[2].shadow: "));
}

TEST_F(SeveralMistakes, NameNoNumberThatNobodyWrote) {
    EXPECT_EQ(mistake("[surface]\nformula = \"x\"\n[time]\nframes = \"a\"\nseconds = 2\n"),
              "scene.toml:4: time.frames: must be an integer");
}

// A section that misses what was taken out of it goes, too, and what follows is read.
TEST_F(SeveralMistakes, GoOnBehindAKeyThatIsNeeded) {
    const std::string words =
        mistake("[surface]\nformula = \"x\"\nbounds = { sphere = 1 }\n[camera]\nfov = \"a(\"\n"
                "[environment]\nmap = \"nothere.hdr\"\n");
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:5: camera.fov: "));
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:7: environment.map: "));
}

TEST_F(SeveralMistakes, OfValuesThatWereSetComeFirst) {
    EXPECT_EQ(mistake(ball_with(12, "fob = 40"), {"output.size=3"}),
              "--set: output.size: must be [width, height], integers from 1 to 16384\n"
              "scene.toml:12: camera.fob: unknown key; did you mean 'fov'?");
}

// Reading a scene without bounds, its document is changed: places stay.
TEST_F(SeveralMistakes, HavePlacesInSceneswithoutBounds) {
    EXPECT_THAT(mistake("[surface]\n\nformula = \"x^2 + y^2 = q\"\n"),
                testing::StartsWith("scene.toml:3: surface.formula: unknown name 'q'"));
}

TEST_F(SeveralMistakes, AreToldUpToTwenty) {
    std::string scene = "[surface]\nformula = \"x\"\n[camera]\n";
    for (int k = 0; k < 40; ++k) scene += "unknown_key_" + std::to_string(k) + " = 1\n";
    const std::string words = mistake(scene);
    EXPECT_EQ(std::ranges::count(words, '\n'), 19);
}

TEST_F(SeveralMistakes, SecondsAreFrames) {
    const std::string start = "[surface]\nformula = \"x\"\n[time]\n";
    const Scene three = load_text(start + "fps = 24\nseconds = 3\n", "scene.toml");
    EXPECT_EQ(three.timeline.frames, 72);
    EXPECT_EQ(
        mistake(start + "frames = 90\nseconds = 4\n"),
        "scene.toml:5: time.seconds: says again how long the scene is: 90 frames; at fps = 30, "
        "frames = 120 takes these 4 seconds. Keep one of frames and seconds");
    EXPECT_EQ(mistake(start + "seconds = 0.001\n"),
              "scene.toml:4: time.seconds: is 0 frames; a scene has from 1 to 10000000");
}

} // namespace
} // namespace isomotion::scene
