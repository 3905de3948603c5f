// Keys that are not known, missing, or not to be together.
#include "testing.h"

namespace isomotion::scene {
namespace {

class KeyMistakes : public Scenes {
protected:
    void expect(std::initializer_list<Mistake> mistakes) const {
        for (const auto& [text, message] : mistakes) EXPECT_EQ(mistake(text), message) << text;
    }
};

TEST_F(KeyMistakes, TheBallHasNone) { EXPECT_EQ(mistake(ball()), "nothing is wrong"); }

TEST_F(KeyMistakes, UnknownKeysWithTheNearestNameOfEveryLevel) {
    expect({
        {ball_with(1, "titel = \"A ball\""),
         "scene.toml:1: titel: unknown key; did you mean 'title'?"},
        {ball_and("[materiel]\ncolor = [1, 1, 1]"),
         "scene.toml:15: materiel: unknown key; did you mean 'material'?"},
        {ball_with(4, "frame = 60"),
         "scene.toml:4: time.frame: unknown key; did you mean 'frames'?"},
        {ball_with(7, "bounds = { sphere = 1.5 }\nplacment = { scale = 2 }"),
         "scene.toml:8: surface.placment: unknown key; did you mean 'transform'?"},
        {ball_with(7, "bounds = { sphere = 1.5, center = [0, 0, 1] }"),
         "scene.toml:7: surface.bounds.center: unknown key; did you mean 'centre'?"},
        {ball_with(7, "bounds = { sphere = 1.5 }\ntransform = { rotat = [0, 0, 1] }"),
         "scene.toml:8: surface.transform.rotat: unknown key; did you mean 'rotate'?"},
        {ball_with(12, "fob = 40"), "scene.toml:12: camera.fob: unknown key; did you mean 'fov'?"},
        {ball_and("[[lights]]\ndirection = [0, 0, 1]\ncolour = [1, 1, 1]"),
         "scene.toml:17: lights[0].colour: unknown key; did you mean 'color'?"},
        {ball_and("[[lights]]\ndirection = [0, 0, 1]\n[[lights]]\ndirections = [0, 0, 1]\n"
                  "direction = [0, 0, 1]"),
         "scene.toml:18: lights[1].directions: unknown key; did you mean 'direction'?"},
        {ball_and("[material]\ncolr = [1, 1, 1]"),
         "scene.toml:16: material.colr: unknown key; did you mean 'color'?"},
        {ball_and("[isolation]\nbisection = 4"),
         "scene.toml:16: isolation.bisection: unknown key; did you mean 'bisections'?"},
        {ball_with(14, "szie = [64, 64]"),
         "scene.toml:14: output.szie: unknown key; did you mean 'size'?"},
    });
}

TEST_F(KeyMistakes, UnknownKeysFarFromAnyAreToldWhatThereIs) {
    expect({
        {ball_with(12, "zoom_level = 40"),
         "scene.toml:12: camera.zoom_level: unknown key; known here: aperture, azimuth, distance, "
         "elevation, focus, fov, height, position, projection, shutter, "
         "target, up, zoom"},
        {ball_and("[weather]\nrain = 1"),
         "scene.toml:15: weather: unknown key; known here: ambient, arrays, "
         "camera, environment, fog, ground, isolation, lights, look, "
         "material, occlusion, output, parameters, sections, surface, surfaces, time, "
         "title"},
    });
}

TEST_F(KeyMistakes, Keyframes) {
    expect({
        {ball_with(9, "radius = { keys = [[0, 1]], easing = \"hold\" }"),
         "scene.toml:9: parameters.radius.easing: unknown key; keyframes are { keys = [[t, value], "
         "...], ease = \"linear\" }"},
        {ball_with(12, "fov = { ease = \"hold\" }"),
         "scene.toml:12: camera.fov: needs keys = [[t, value], ...], at least one"},
        {ball_with(12, "fov = { keys = [] }"),
         "scene.toml:12: camera.fov: needs keys = [[t, value], ...], at least one"},
        {ball_with(9, "radius = { ease = \"hold\" }"),
         "scene.toml:9: parameters.radius: needs a default, or keys = [[t, value], ...]"},
    });
}

TEST_F(KeyMistakes, WhatIsMissing) {
    expect({
        {"title = \"Nothing\"\n", "scene.toml:1: surface: is missing; give formula = \"...\" and "
                                  "bounds, or use = \"name\" of "
                                  "the catalogue"},
        {"title = \"Nothing\"\n[surface]\n",
         "scene.toml:2: surface: needs formula = \"...\", or use = \"name\" of the catalogue"},
        {ball_with(6, ""),
         "scene.toml:5: surface: needs formula = \"...\", or use = \"name\" of the "
         "catalogue"},
        {ball_with(7, "bounds = { centre = [0, 0, 0] }"),
         "scene.toml:7: surface.bounds: needs one of sphere = radius and box = [[..], [..]]"},
        {ball_and("[[lights]]\ncolor = [1, 1, 1]"),
         "scene.toml:15: lights[0]: needs one of direction = [x, y, z], pointing to the light, and "
         "position = [x, y, z]"},
    });
}

TEST_F(KeyMistakes, OneOfTwo) {
    surface("sphere", "formula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 2 }\n");
    expect({
        {ball_with(6, "use = \"sphere\"\nformula = \"x - 1\""),
         "scene.toml:7: surface.formula: the surface has `use` already; keep one"},
        {ball_with(7, "bounds = { sphere = 1, box = [[-1, -1, -1], [1, 1, 1]] }"),
         "scene.toml:7: surface.bounds: needs one of sphere = radius and box = [[..], [..]]"},
    });
}

TEST_F(KeyMistakes, SectionsThatAreNoTables) {
    expect({
        {"surface = 3\n", "scene.toml:1: surface: must be a table: [surface]"},
        {"camera = [1, 2]\n" + ball_with(10, "[old]"),
         "scene.toml:1: camera: must be a table: [camera]\n"
         "scene.toml:11: old: unknown key; known here: ambient, arrays, camera, environment, "
         "fog, ground, isolation, lights, look, material, occlusion, output, parameters, sections, "
         "surface, surfaces, time, title"},
        {ball_with(7, "bounds = 3"),
         "scene.toml:7: surface.bounds: must be a table: [surface.bounds]"},
        {"arrays = 3\n" + ball(), "scene.toml:1: arrays: must be a table: [arrays]"},
        {ball_and("[arrays]\nblobs = 75"),
         "scene.toml:16: arrays.blobs: must be a table: [arrays.blobs]"},
    });
}

TEST_F(KeyMistakes, LightsAreAnArrayOfTables) {
    const std::string message =
        "scene.toml:1: lights: must be written as [[lights]], one such table a light";
    for (const char* lights :
         {"lights = 3", "lights = []", "lights = [1, 2]", "lights = { direction = [0, 0, 1] }"}) {
        EXPECT_EQ(mistake(lights + std::string("\n") + ball()), message) << lights;
    }
    EXPECT_EQ(mistake(ball_and("[lights]\ndirection = [0, 0, 1]")),
              "scene.toml:15: lights: must be written as [[lights]], one such table a light");

    std::string many;
    for (int k = 0; k < 8; ++k) many += "[[lights]]\ndirection = [0, 0, 1]\n";
    EXPECT_EQ(mistake(ball_and(many)), "nothing is wrong");
    EXPECT_EQ(mistake(ball_and(many + "[[lights]]\ndirection = [0, 0, 1]")),
              "scene.toml:15: lights: at most 8");
}

TEST_F(KeyMistakes, ParametersThatNothingUses) {
    expect({
        {ball_with(9, "radius = 1\nspeed = 3"), "scene.toml:10: parameters.speed: neither the "
                                                "formula nor an expression uses this parameter"},
        {ball_with(9, "radius = 1\nraduis = 3"),
         "scene.toml:10: parameters.raduis: nothing uses this parameter; did you mean 'radius'?"},
    });
    EXPECT_EQ(mistake(ball_with(9, "radius = \"speed*t\"\nspeed = 3")), "nothing is wrong");
    EXPECT_EQ(mistake(ball_with(12, "fov = \"speed + t\"\n[parameters.speed]\nkeys = [[0, 3]]")),
              "nothing is wrong");
}

TEST_F(KeyMistakes, NamesThatMeanSomethingElse) {
    for (const char* name : {"x", "z", "sin", "pi", "sum", "random", "chebyshev"}) {
        EXPECT_EQ(mistake(ball_with(9, "radius = 1\n" + std::string(name) + " = 2")),
                  "scene.toml:10: parameters." + std::string(name) + ": '" + name +
                      "' already has a meaning in formulas; choose another name");
    }
    EXPECT_EQ(
        mistake(ball_with(9, "radius = 1\nt = 2")),
        "scene.toml:10: parameters.t: 't' means the time in expressions; choose another name");
    for (const char* name : {"\"a b\"", "\"\"", "2nd", "half-way", "\"a.b\"", "\"ä\""}) {
        EXPECT_THAT(
            mistake(ball_with(9, "radius = 1\n" + std::string(name) + " = 2")),
            testing::AllOf(testing::StartsWith("scene.toml:10: parameters."),
                           testing::EndsWith(": a name is letters, digits and _, and starts "
                                             "with a letter")))
            << name;
    }
}

} // namespace
} // namespace isomotion::scene
