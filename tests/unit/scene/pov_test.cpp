// Files of POV-Ray as scenes.
#include "testing.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "formula/field.h"
#include "scene/reading/pov.h"
#include "scene/scene_at.h"

namespace isomotion::scene::pov_test {
namespace {

using testing::HasSubstr;

constexpr const char* pov_ball = R"(// a ball that is cut by waves
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }
#declare R = 2; /* a comment /* in a comment */ */
#declare Wave = function(a, b) { sin(3*a) * b }
camera {
  location <0, 1, -4>
  look_at <0, 1, 0>
  angle 60
}
background { rgb <0.1, 0.2, 0.3> }
light_source { <5, 8, -4> color rgb <1, 0.5, 0> }
isosurface {
  function { x*x + y*y*2 + pow(z, 2) - R^2 + Wave(x + 1, 0.1) }
  threshold 0.5
  contained_by { box { <-3, -2, -1>, <3, 2, 1> } }
  pigment { color Red }
  rotate 90*y
  translate <0, 1, 0>
}
)";

std::string with(const std::string& part, const std::string& instead) {
    std::string text = pov_ball;
    return text.replace(text.find(part), part.size(), instead);
}

Scene scene_of(const std::string& text) { return load_text(text, "ball.pov"); }

std::string mistake_of(const std::string& text) { return mistake_of_text(text, "ball.pov"); }

glm::dvec3 vector(const animation::Values& values, const Vec3Track& track) {
    return {values.tracks[std::size_t(track[0])], values.tracks[std::size_t(track[1])],
            values.tracks[std::size_t(track[2])]};
}

// What a scene's formula is at a place, in its own coordinates.
double value_at(const std::string& text, const glm::dvec3& place) {
    const Scene scene = scene_of(text);
    const SceneAt now = at_frame(scene, 1);
    formula::Evaluator<double> evaluator(scene.surfaces[0].field->value);
    double value = 0;
    evaluator.point(formula::convert<double>(now.surfaces[0].bindings),
                    std::array{place.x, place.y, place.z}, {&value, 1});
    return value;
}

// Its y is up, as our z is.
TEST(Pov, FormulaParametersAndBounds) {
    const Scene scene = scene_of(pov_ball);
    const SceneAt now = at_frame(scene, 1);
    EXPECT_EQ(scene.title, "ball");
    EXPECT_EQ(now.surfaces[0].bindings.parameters.front(), 2);
    ASSERT_EQ(now.surfaces[0].bounds.shape, Bounds::Shape::box);
    EXPECT_EQ(now.surfaces[0].bounds.max, glm::dvec3(3, 1, 2));
    const glm::dvec3 p(0.3, -0.4, 0.7); // their x, z and y
    const double expected =
        p.x * p.x + 2 * p.z * p.z + p.y * p.y - 4 + 0.1 * std::sin(3 * (p.x + 1)) - 0.5;
    EXPECT_NEAR(value_at(pov_ball, p), expected, 1e-12);
}

TEST(Pov, CameraLightsAndColours) {
    const Scene scene = scene_of(pov_ball);
    const auto values = scene.surfaces[0].animation.at(scene.timeline.time(1));
    EXPECT_EQ(vector(values, *scene.camera.position), glm::dvec3(0, -4, 1));
    EXPECT_EQ(vector(values, *scene.camera.target), glm::dvec3(0, 0, 1));
    EXPECT_EQ(vector(values, scene.camera.up), glm::dvec3(0, 0, 1));
    // 60 degrees across a picture of 4 : 3.
    EXPECT_NEAR(values.tracks[std::size_t(scene.camera.fov)],
                2 * std::atan(0.75 * std::tan(M_PI / 6)) * 180 / M_PI, 1e-9);
    ASSERT_EQ(scene.lights.size(), 1);
    EXPECT_EQ(vector(values, scene.lights[0].direction), glm::dvec3(5, -4, 8));
    EXPECT_NEAR(vector(values, scene.lights[0].color).y, 0.3, 1e-12);
    EXPECT_TRUE(scene.lights[0].shadow);
    EXPECT_EQ(vector(values, scene.surfaces[0].material.color), glm::dvec3(1, 0, 0));
    EXPECT_EQ(scene.output.background, (std::array<double, 3>{0.1, 0.2, 0.3}));
    EXPECT_EQ(scene.output.height, 480);
}

// A point of the object and where POV-Ray takes it: x to -z by 90 degrees about y, then up.
TEST(Pov, TransformsTakePointsWherePovRayDoes) {
    const Scene scene = scene_of(pov_ball);
    const SceneAt now = at_frame(scene, 1);
    const auto taken = [&](const glm::dvec3& p) { return now.surfaces[0].placement.to_world(p); };
    EXPECT_NEAR(glm::length(taken({1, 0, 0}) - glm::dvec3(0, -1, 1)), 0, 1e-9);
    EXPECT_NEAR(glm::length(taken({0, 1, 0}) - glm::dvec3(1, 0, 1)), 0, 1e-9);
    const Scene turned = scene_of(with("rotate 90*y", "scale 2 rotate <30, 40, 50>"));
    const SceneAt then = at_frame(turned, 1);
    // Rz Ry Rx in POV-Ray's axes, of the point (1, 2, 3) times 2.
    const glm::dvec3 a = glm::radians(glm::dvec3(30, 40, 50)), c = glm::cos(a), s = glm::sin(a);
    glm::dvec3 p(2, 4, 6);
    p = {p.x, c.x * p.y - s.x * p.z, s.x * p.y + c.x * p.z};
    p = {c.y * p.x + s.y * p.z, p.y, -s.y * p.x + c.y * p.z};
    p = {c.z * p.x - s.z * p.y, s.z * p.x + c.z * p.y, p.z};
    const glm::dvec3 ours = then.surfaces[0].placement.to_world({1, 3, 2});
    EXPECT_NEAR(glm::length(ours - glm::dvec3(p.x, p.z, p.y + 1)), 0, 1e-9);
}

TEST(Pov, PolynomialsHaveTheirTermsInPovRaysOrder) {
    const glm::dvec3 p(0.7, -0.3, 1.1); // x, z and y
    const double x = p.x, y = p.z, z = p.y;
    std::string list;
    double expected = 0;
    int k = 0;
    for (const double term :
         {x * x * x, x * x * y, x * x * z, x * x,     x * y * y, x * y * z, x * y,
          x * z * z, x * z,     x,         y * y * y, y * y * z, y * y,     y * z * z,
          y * z,     y,         z * z * z, z * z,     z,         1.0}) {
        ++k;
        list += fmt::format("{}{}", k > 1 ? ", " : "", k % 3 - 1.5 + k);
        expected += (k % 3 - 1.5 + k) * term;
    }
    EXPECT_NEAR(value_at("cubic { <" + list + "> }", p), expected, 1e-9);
    EXPECT_NEAR(value_at("poly { 3, <" + list + "> sturm }", p), expected, 1e-9);
    EXPECT_NEAR(value_at("quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, -10 }", p),
                x * x + 2 * y * y + 3 * z * z + 4 * x * y + 5 * x * z + 6 * y * z + 7 * x + 8 * y +
                    9 * z - 10,
                1e-9);
}

TEST(Pov, TheClockMoves) {
    const Scene scene =
        scene_of("isosurface { function { x*x + y*y + z*z - 1 - clock } rotate 360*clock*y }");
    EXPECT_EQ(scene.timeline.frames, 31);
    const SceneAt end = at_frame(scene, 16);
    EXPECT_NEAR(end.surfaces[0].bindings.parameters.front(), 0.5, 1e-12);
    EXPECT_NEAR(
        glm::length(end.surfaces[0].placement.rotate * glm::dvec3(1, 0, 0) - glm::dvec3(-1, 0, 0)),
        0, 1e-9);
}

TEST(Pov, DeclaredObjectsAndLooks) {
    const Scene scene = scene_of("#declare Red_ = texture { pigment { rgb <1, 0, 0> } finish "
                                 "{ phong 1 } }\n#declare Ball = quadric { <1, 1, 1>, 0, 0, -1 "
                                 "texture { Red_ } }\nobject { Ball }\n");
    EXPECT_EQ(vector(scene.surfaces[0].animation.at(scene.timeline.time(1)),
                     scene.surfaces[0].material.color),
              glm::dvec3(1, 0, 0));
    EXPECT_EQ(scene.surfaces[0].material.model, Material::Model::blinn_phong);
}

// What cuts the surface counts; what only saves time does where nothing cuts it.
TEST(Pov, BoundsAreOneShape) {
    const auto bounds_of = [](const std::string& parts) {
        const Scene scene = scene_of("quadric { <1, 1, -1>, 0, 0, -1 " + parts + " }\n");
        return at_frame(scene, 1).surfaces[0].bounds;
    };
    const std::string ball = "{ sphere { 0, 2 } } ", box = "{ box { -3, 3 } } ";
    EXPECT_EQ(bounds_of("clipped_by " + ball + "bounded_by { clipped_by }").radius, 2);
    EXPECT_EQ(bounds_of("clipped_by " + ball + "bounded_by " + box).radius, 2);
    EXPECT_EQ(bounds_of("bounded_by " + box + "clipped_by " + ball).radius, 2);
    EXPECT_EQ(bounds_of("bounded_by " + box).max.x, 3);
    const Scene unit = scene_of("isosurface { function { x*x + y*y + z*z - 1.2 } }\n");
    EXPECT_EQ(at_frame(unit, 1).surfaces[0].bounds.min, glm::dvec3(-1));
    EXPECT_THAT(mistake_of("isosurface { function { x }\ncontained_by " + ball + "\ncontained_by " +
                           box + "}\n"),
                testing::StartsWith("ball.pov:3: contained_by: is the second shape"));
}

TEST(Pov, MistakesHaveTheLinesOfTheFile) {
    const auto expect = [](const std::string& text, const std::string& start) {
        EXPECT_THAT(mistake_of(text), testing::StartsWith("ball.pov:" + start));
    };
    expect(with("x*x + y", "x*x + q"), "15: function: 'q' is not declared before");
    expect(with("Wave(x", "Wav(x"), "15: function: the function Wav is not read; read are min");
    expect(with("isosurface {", "julia_fractal {"), "14: julia_fractal: is not read; a scene is");
    expect(with("angle 60", "fisheye"), "11: camera: 'fisheye' is not read; read are location");
    expect(with("rotate 90*y", "scale <1, 0, 1>"), "19: scale: must not be 0 along an axis");
    expect(with("pigment { color Red }", "pigment { checker }"), "18: pigment: its pattern");
    expect(with("\"colors.inc\"", "\"my.inc\""), "3: #include: \"my.inc\" is not read: put");
    expect(with("global_settings {", "#while (1) {"), "4: #while: is not read; read are #declare");
    expect(with("in a comment */ */", "in a comment */"), "5: /*: this comment has no end");
    expect(pov_ball + std::string("height_field { 0 }"), "22: height_field: is not read");
    expect("sphere { 0, 1\nrotate }", "2: rotate: needs a number, a vector or a name before '}'");
    expect("union { }", "1: union: needs objects before '}'");
    expect("object {\nBal }", "2: object: 'Bal' is not declared before");
    expect("camera { location <0, 0, 0> }", "1: isosurface: is missing; a scene is one");
    expect("cubic { <1, 2, 3> }", "1: cubic: needs 20 numbers");
    expect("isosurface { function { x", "1: function: needs '}' before 'the end of the file'");
    EXPECT_THAT(mistake_of(with("look_at", "look_at <1, 2>+")), HasSubstr("ball.pov:9: look_at"));
}

// No file takes long to refuse or to read.
TEST(Pov, HostileFilesEnd) {
    std::string deep = "isosurface { function { ", calls = "#declare f = function(x) { x + x }\n";
    for (int k = 0; k < 100'000; ++k) deep += "(";
    EXPECT_THAT(mistake_of(deep), HasSubstr("in one another"));
    EXPECT_THAT(mistake_of("#declare f = function(x) { f(x) }\nisosurface { function { f(x) } }"),
                HasSubstr("the function f is not read"));
    std::string nested = "x";
    for (int k = 0; k < 24; ++k) nested = "f(" + nested + ")";
    EXPECT_THAT(mistake_of(calls + "isosurface { function { " + nested + " } }"),
                HasSubstr("too long a formula"));
    for (const char* text :
         {"", "#", "#declare", "#declare a", "#declare a =", "object {", "camera {",
          "poly { 2.5, <1> }", "poly { 35, <1> }", "\"", "<", "}",
          "isosurface { function { x.y } }", "light_source { <1, 2> }", "union {",
          "difference { sphere { 0, 1 }", "quadric { <1,2,3>", "#declare f = function(x"})
        EXPECT_THAT(mistake_of(text), testing::StartsWith("ball.pov:")) << text;
}

// What doubles with each line, and what calls itself without a parenthesis.
TEST(Pov, FilesThatGrowAreRefused) {
    const auto repeated = [](const std::string& part, int count) {
        std::string text;
        for (int k = 0; k < count; ++k) text += part;
        return text;
    };
    std::string calls = "#declare f0 = function(a) { 1 }\n", turns, values, names;
    for (int k = 1; k < 12; ++k) {
        calls += fmt::format("#declare f{} = function(a) {{ {}0 }}\n", k,
                             repeated(fmt::format("f{}(a)+", k - 1), 10));
    }
    turns = "#declare T0 = transform { rotate x }\n";
    for (int k = 1; k < 30; ++k)
        turns += fmt::format("#declare T{0} = transform {{ T{1} T{1} }}\n", k, k - 1);
    for (int k = 0; k <= 10'000; ++k) values += fmt::format("#declare a{} = 1;\n", k);
    EXPECT_THAT(mistake_of(calls + "sphere { 0, f11(1) }"), HasSubstr("more than 100000 calls"));
    EXPECT_THAT(mistake_of(turns + "sphere { 0, 1 transform T29 }"), HasSubstr("transformations"));
    EXPECT_THAT(mistake_of(values + "sphere { 0, 1 }"), HasSubstr("more than 10000 values"));
    EXPECT_THAT(mistake_of("sphere { 0, " + repeated("1^", 40'000) + "1 }"),
                HasSubstr("in one another"));
    EXPECT_THAT(mistake_of("background { " + repeated("color ", 200'000) + "rgb 1 }"),
                HasSubstr("in one another"));
    for (int k = 0; k < 70; ++k)
        names += fmt::format("#declare A{} = sphere {{ 0, 1 texture {{ bogus }} }}\n", k);
    EXPECT_EQ(mistake_of(names + "sphere { 0, 1 texture { pigment { rgb 1 } } }"),
              "nothing is wrong");
}

// A declaration that fails leaves nothing behind: its function's arguments are no names any more.
TEST(Pov, FailedDeclarationsLeaveNothingBehind) {
    const std::string text = "#declare F = function(a) { a + bogus }\n"
                             "#declare S = sphere { 0, F(1) }\nsphere { ";
    EXPECT_EQ(mistake_of(text + "x*2 + 1, 1 }"), "nothing is wrong");
    EXPECT_THAT(mistake_of(text + "a, 1 }"), HasSubstr("'a' is not declared before"));
}

// What was read keeps the value that a name had then, also in functions.
TEST(Pov, NamesMayBeDeclaredAgain) {
    const glm::dvec3 p(2, 0, 0);
    EXPECT_NEAR(value_at("#declare R = 1; #declare R = R + 1; sphere { 0, R }", p), 0, 1e-12);
    EXPECT_NEAR(value_at("#declare R = 1; #declare F = function { x*x + y*y + z*z - R }\n"
                         "#declare R = 2; isosurface { function { F(x, y, z) + 0*R } }",
                         p),
                3, 1e-12);
    const Scene two = scene_of("#declare R = 1; sphere { 0, R }\n"
                               "#declare R = 2; sphere { <5, 0, 0>, R pigment { rgb 1 } }");
    ASSERT_EQ(two.surfaces.size(), 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const SceneAt now = at_frame(two, 1);
        double value = 0;
        formula::Evaluator<double>(two.surfaces[k].field->value)
            .point(formula::convert<double>(now.surfaces[k].bindings),
                   std::array{k == 0 ? 1.0 : 3.0, 0.0, 0.0}, {&value, 1});
        EXPECT_NEAR(value, 0, 1e-12) << k;
    }
}

TEST(Pov, NamesMayBeDeclaredAgainAsAnything) {
    std::string counter = "#declare N = 0;\n";
    for (int k = 0; k < 3000; ++k) counter += "#declare N = N + 0.001;\n";
    EXPECT_NEAR(value_at(counter + "sphere { 0, N }", {3, 0, 0}), 0, 1e-9);
    EXPECT_NEAR(value_at("#declare f = function(x) { x + 1 }\n#declare g = function(x) { f(x)*2 }\n"
                         "#declare f = function(x) { f(x) + 100 }\n"
                         "isosurface { function { g(x) + 0.001*f(x) } }",
                         {1, 0, 0}),
                4.102, 1e-12);
    EXPECT_NEAR(
        value_at("#declare R = 1; #declare R = 2; #declare R_2 = 3; sphere { 0, R_2 }", {3, 0, 0}),
        0, 1e-12);
    EXPECT_NEAR(value_at("#declare e = 2; #declare R = e; sphere { 0, R }", {2, 0, 0}), 0, 1e-12);
    const Scene scene =
        scene_of("#declare P = pigment { rgb <1, 0, 0> }\n#declare P = rgb <0, 1, 0>;\n"
                 "sphere { 0, 1 pigment { P } }");
    EXPECT_EQ(at_frame(scene, 1).surfaces[0].color, glm::dvec3(0, 1, 0));
    EXPECT_THAT(mistake_of("#declare S = sphere { 0, 1 }\n#declare S = 3;\nobject { S }"),
                HasSubstr("'S' is not declared before"));
    EXPECT_THAT(mistake_of("background { rgb 1 }\nbackground { rgb 0 }\nsphere { 0, 1 }"),
                HasSubstr("2: background: is there a second time"));
}

// Height of an orthographic picture: right and up where they alone are given, else what a camera in
// perspective would show at its target.
TEST(Pov, OrthographicCamerasHavePovRaysSize) {
    const auto height = [](const std::string& more) {
        const Scene scene = scene_of("camera { orthographic location <0, 0, -5> look_at 0 " + more +
                                     " } sphere { 0, 1 }");
        const SceneAt now = at_frame(scene, 1);
        return now.camera.height;
    };
    EXPECT_NEAR(height("angle 30"), 2 * 5 * std::tan(glm::radians(15.0)) * 0.75, 1e-5);
    EXPECT_NEAR(height(""), 5, 1e-12);
    EXPECT_NEAR(height("right x*4 up y*3"), 3, 1e-12);
    EXPECT_THAT(mistake_of("camera { right -x*4/3 look_at z } sphere { 0, 1 }"),
                HasSubstr("points to the left"));
}

TEST(Pov, LightPassesWhereItIsNotColoured) {
    const auto is_seen = [](const std::string& pigment) {
        return mistake_of("sphere { 0, 1 pigment { " + pigment + " } }") == "nothing is wrong";
    };
    for (const char* clear : {"rgbt 1", "rgbf 1", "rgb 1 transmit 1", "rgbt <1, 0, 0, 1>",
                              "color rgb <1, 1, 1> filter 1", "Clear"})
        EXPECT_FALSE(is_seen(clear)) << clear;
    for (const char* seen : {"rgbf <1, 0, 0, 1>", "rgb 1", "rgb 1 transmit 0.5", "White"})
        EXPECT_TRUE(is_seen(seen)) << seen;
}

// Functions of declared numbers stand still.
TEST(Pov, FunctionsOfNumbersAreNumbers) {
    for (const char* text :
         {"#declare A = 30; cylinder { 0, <2*cos(radians(A)), sin(A), pow(2, 2)>, 0.2 }",
          "#declare A = 30; plane { <sin(radians(A)), 1, 0>, max(-1, -2) }",
          "#declare A = 3; sphere { 0, 1 matrix <select(A, 1, 2), 0, 0, 0, mod(A, 2), 0, "
          "0, 0, atan2(1, A), 0, 0, 0> }",
          "sphere { 0, 1 matrix <1e-5, 0, 0, 0, 1e-5, 0, 0, 0, 1e-5, 0, 0, 0> }"})
        EXPECT_EQ(mistake_of(text), "nothing is wrong") << text;
    EXPECT_THAT(mistake_of("sphere { 0, 1 matrix <1, 2, 3, 2, 4, 6, 0, 0, 1, 0, 0, 0> }"),
                HasSubstr("makes the object flat"));
}

// POV-Ray has a wall wherever the sign changes.
TEST(Pov, JumpsOfIsosurfacesAreWalls) {
    const auto has_walls = [](const std::string& function) {
        return scene_of("isosurface { function { " + function + " } }").surfaces[0].jumps_are_walls;
    };
    EXPECT_TRUE(has_walls("select(y, x*x + y*y + z*z - 1, 1)"));
    EXPECT_TRUE(has_walls("y - floor(3*x)/3"));
    EXPECT_FALSE(has_walls("x*x + y*y + z*z - 1"));
}

} // namespace
} // namespace isomotion::scene::pov_test
