// A scene with several mistakes: all are told, by line, and none that only follows from another.
#include <fmt/format.h>

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
              "scene.toml:2: surface.formla: unknown key; did you mean 'formula'?");
    // Nothing but the wrong formula uses r.
    EXPECT_THAT(mistake("[surface]\nformula = \"x = r +\"\n[parameters]\nr = 1\n"),
                testing::StartsWith("scene.toml:2: surface.formula: the formula ends where"));
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

TEST_F(SeveralMistakes, OfOneSection) {
    EXPECT_EQ(mistake("[surface]\nformula = \"x + q\"\n"
                      "bounds = { sphere = -1, center = [0, 0, 0] }\n"
                      "transform = { scale = 0, rotat = [0, 0, 1] }\n"
                      "[material]\nmodel = \"gx\"\ncolor = \"red\"\nroughness = 7\n"
                      "[camera]\nprojection = \"flat\"\nheight = -3\nzoom = 0\n"),
              "scene.toml:2: surface.formula: unknown name 'q'; known: x, y, z, pi\n"
              "    x + q\n"
              "        ^\n"
              "scene.toml:3: surface.bounds.center: unknown key; did you mean 'centre'?\n"
              "scene.toml:3: surface.bounds.sphere at t = 0: the radius must be above 0, not -1\n"
              "scene.toml:4: surface.transform.rotat: unknown key; did you mean 'rotate'?\n"
              "scene.toml:4: surface.transform.scale at t = 0: must be above 0, not 0\n"
              "scene.toml:6: material.model: there is no model 'gx'; did you mean 'ggx'? known: "
              "lambert, blinn-phong, ggx\n"
              "scene.toml:7: material.color: must be [r, g, b], linear ([1, 0, 0] is red), or "
              "{ keys = [[t, [r, g, b]], ...] }\n"
              "scene.toml:10: camera.projection: there is no projection 'flat'; known: "
              "perspective, orthographic\n"
              "scene.toml:11: camera.height at t = 0: must be above 0, not -3\n"
              "scene.toml:12: camera.zoom at t = 0: must be above 0, not 0");
}

// Vectors of three tables of keys are no lists of lights.
TEST_F(SeveralMistakes, OfVectorsOfKeys) {
    const std::string words =
        mistake("[surface]\nformula = \"x\"\n[camera]\n"
                "position = [{ keys = [[0, 1], [1, \"q\"]] }, { keys = [[0, 1]] }, "
                "{ keys = [[0, 1]] }]\nzoom = 0\n[[lights]]\ndirection = [0, 0, 1]\n"
                "color = [{ keys = [[0, 1]] }, { keys = [[0, \"w\"]] }, { keys = 3 }]\n");
    EXPECT_THAT(words, testing::HasSubstr("camera.position"));
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:5: camera.zoom"));
    EXPECT_THAT(words, testing::HasSubstr("lights[0].color"));
    EXPECT_THAT(words, testing::Not(testing::HasSubstr("direction")));
}

TEST_F(SeveralMistakes, OfAWrongLook) {
    const std::string words = mistake("look = \"studioo\"\n[surface]\nformula = \"x + q\"\n");
    EXPECT_THAT(words, testing::HasSubstr("scene.toml:1: look: there is no look"));
    EXPECT_THAT(words, testing::HasSubstr("surface.formula: unknown name 'q'"));
    EXPECT_THAT(words, testing::Not(testing::HasSubstr("bounds")));
}

TEST_F(SeveralMistakes, OfValuesOutOfRange) {
    EXPECT_EQ(mistake("[surface]\nformula = \"x\"\n[camera]\nfov = \"200 - t\"\nzoom = -1\n"
                      "[fog]\ndensity = -1\n[[lights]]\ndirection = [0, 0, 0]\nradius = 90\n"),
              "scene.toml:4: camera.fov at t = 0: must be above 0 and below 180, not 200\n"
              "scene.toml:5: camera.zoom at t = 0: must be above 0, not -1\n"
              "scene.toml:7: fog.density at t = 0: must be 0 or above, not -1\n"
              "scene.toml:9: lights[0].direction.x at t = 0: the direction to the light has length "
              "0\n"
              "scene.toml:10: lights[0].radius at t = 0: must be from 0 to 45, not 90");
}

TEST_F(SeveralMistakes, OfArraysThatStandInTheFile) {
    EXPECT_EQ(mistake(blobs("count = 3\ncx = \"2*j\"\nw = true") + "\n[camera]\nfob = 3\n"),
              "scene.toml:6: arrays.blobs.cx: unknown name 'j'; known: t, i, n, cx, w, pi\n"
              "    2*j\n"
              "      ^\n"
              "scene.toml:7: arrays.blobs.w: must be a number, an expression in t, i and n, or a "
              "list of numbers\n"
              "scene.toml:10: camera.fob: unknown key; did you mean 'fov'?");
}

TEST_F(SeveralMistakes, OfSeveralSurfacesWhatTheyShareOnce) {
    EXPECT_EQ(mistake("[[surfaces]]\nformula = \"x + q\"\n[[surfaces]]\nformula = \"x\"\n"
                      "transform = { scale = 0 }\n[camera]\nfob = 3\n"),
              "scene.toml:2: surfaces.1.formula: unknown name 'q'; known: x, y, z, pi\n"
              "    x + q\n"
              "        ^\n"
              "scene.toml:5: surfaces.2.transform.scale at t = 0: must be above 0, not 0\n"
              "scene.toml:7: camera.fob: unknown key; did you mean 'fov'?");
}

TEST_F(SeveralMistakes, OfAFormulaWithoutAPlace) {
    for (const char* formula : {"1=1", "3", "x - x = 0", "pi"})
        EXPECT_EQ(mistake(fmt::format("[surface]\nformula = \"{}\"\n", formula)),
                  "scene.toml:2: surface.formula: the formula has the same value everywhere and so "
                  "no surface; write an equation of x, y and z");
    // All of space, of which a section shows a cap.
    EXPECT_EQ(mistake("[surface]\nformula = \"-1\"\nbounds = { sphere = 1 }\n"
                      "[[sections]]\nnormal = [0, 0, 1]\n"),
              "nothing is wrong");
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

TEST_F(SeveralMistakes, GoOnWhereTheSurfaceIsMissing) {
    EXPECT_EQ(mistake("[output]\nsize = [64, 64]\nsurfaces = []\n[camera]\nfvo = 3\n"),
              "scene.toml:1: surface: is missing; give formula = \"...\" and bounds, or use = "
              "\"name\" of the catalogue\n"
              "scene.toml:3: output.surfaces: unknown key; known here: background, poster, "
              "samples, size\n"
              "scene.toml:5: camera.fvo: unknown key; did you mean 'fov'?");
}

TEST_F(SeveralMistakes, OfValuesThatWereSetComeFirst) {
    EXPECT_EQ(mistake(ball_with(12, "fob = 40"), {"output.size=3"}),
              "--set: output.size: must be [width, height], integers from 1 to 16384\n"
              "scene.toml:12: camera.fob: unknown key; did you mean 'fov'?");
}

// Each stage of reading tells what it finds: kinds of values, expressions, values at a time.
TEST_F(SeveralMistakes, OfAllStagesAtOnce) {
    EXPECT_EQ(mistake("[surface]\nformula = \"x = a + b\"\n[parameters]\na = \"2*s\"\n"
                      "b = \"1 +\"\n[camera]\nfov = \"u\"\nzoom = \"t - 1\"\nup = [0, 0, 0]\n"
                      "target = [\"v\", \"w\", 0]\nposition = 7\n"),
              "scene.toml:4: parameters.a: unknown name 's'; known: t, a, b, pi\n"
              "    2*s\n"
              "      ^\n"
              "scene.toml:5: parameters.b: the formula ends where a value is expected\n"
              "    1 +\n"
              "       ^\n"
              "scene.toml:7: camera.fov: unknown name 'u'; known: t, a, b, pi\n"
              "    u\n"
              "    ^\n"
              "scene.toml:8: camera.zoom at t = 0: must be above 0, not -1\n"
              "scene.toml:9: camera.up.x at t = 0: `up` has no direction\n"
              "scene.toml:10: camera.target.x: unknown name 'v'; known: t, a, b, pi\n"
              "    v\n"
              "    ^\n"
              "scene.toml:11: camera.position: must be [x, y, z] or { keys = [[t, [x, y, z]], ...] "
              "}");
}

// A value that two numbers make wrong is replaced, and what follows it is told, too.
TEST_F(SeveralMistakes, OfRangesHideNoOthers) {
    EXPECT_EQ(mistake("[surface]\nformula = \"x\"\nbounds = { sphere = 1 }\n[material]\n"
                      "colormap = { value = \"z\", range = [0, 0] }\n[occlusion]\nradius = -1\n"),
              "scene.toml:5: material.colormap.range at t = 0: the two ends must differ, and both "
              "are 0\n"
              "scene.toml:7: occlusion.radius at t = 0: must be above 0, not -1");
}

// What surfaces share is wrong once, under the name of the shared section.
TEST_F(SeveralMistakes, OfSharedArraysAreToldOnce) {
    EXPECT_EQ(
        mistake("[[surfaces]]\nname = 3\nformula = \"sum(p, x*w)\"\nbounds = { sphere = 1 }\n"
                "[surfaces.arrays.p]\nw = 1\n[[surfaces]]\nformula = \"sum(p, y)\"\n"
                "bounds = { sphere = 1 }\nmaterial = 3\n[arrays.p]\ncount = -3\n"
                "[[lights]]\nradius = 80\nfalloff = 2\n"),
        "scene.toml:2: surfaces.1.name: must be a text of one line and at most 64 bytes\n"
        "scene.toml:10: surfaces.2.material: must be a table: [surfaces.material]\n"
        "scene.toml:12: arrays.p.count: must be an integer from 0 to 1000000\n"
        "scene.toml:13: lights[0]: needs one of direction = [x, y, z], pointing to the light, "
        "and position = [x, y, z]");
}

// Formulas and colours may name what a wrong array would have had; all else is read.
TEST_F(SeveralMistakes, OfAnArrayHideThoseOfFormulas) {
    EXPECT_EQ(mistake(blobs("count = -1\ncx = 1") +
                      "\n[camera]\nzoom = 0\n[material]\n"
                      "color = [\"least(blobs, cx, cx)\", 0, 0]\nmodel = \"ggx\"\nshininess = 1\n"),
              "scene.toml:5: arrays.blobs.count: must be an integer from 0 to 1000000\n"
              "scene.toml:13: material.shininess: shininess is of model blinn-phong; this one is "
              "ggx");
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
