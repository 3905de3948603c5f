// Formulas and expressions that are wrong: the message shows the place within them.
#include "testing.h"

namespace isomotion::scene {
namespace {

class ExpressionMistakes : public Scenes {
protected:
    void expect(std::initializer_list<Mistake> mistakes) const {
        for (const auto& [text, message] : mistakes) EXPECT_EQ(mistake(text), message) << text;
    }
};

TEST_F(ExpressionMistakes, Formulas) {
    expect({
        {ball_with(6, "formula = \"x^2 + yy - radius\""),
         "scene.toml:6: surface.formula: unknown name 'yy'; did you mean 'y'?\n"
         "    x^2 + yy - radius\n"
         "          ^"},
        {ball_with(6, "formula = \"x - coz(radius)\""),
         "scene.toml:6: surface.formula: there is no function 'coz'; did you mean 'cos'?\n"
         "    x - coz(radius)\n"
         "        ^"},
        {ball_with(6, "formula = \"x^2/0 - radius\""),
         "scene.toml:6: surface.formula: division by zero\n"
         "    x^2/0 - radius\n"
         "       ^"},
        {ball_with(6, "formula = \"\""),
         "scene.toml:6: surface.formula: the formula ends where a value is expected\n"
         "    \n"
         "    ^"},
    });
}

// As on the command line; i and n are names like others where there are no elements.
TEST_F(ExpressionMistakes, TheTimeInAFormulaIsNone) {
    const Scene scene = loaded(ball_with(6, "formula = \"x^2 + y^2 + z^2 - radius - 0.1*t\""));
    const auto at = [&](double t) { return scene.surfaces[0].animation.at(t).tracks; };
    EXPECT_EQ(std::ranges::count(at(1.25), 1.25), 1 + std::ranges::count(at(0.5), 1.25));
    EXPECT_EQ(mistake(ball_with(6, "formula = \"t(u) = u^2; t(x) + t(y) + z^2 - radius\"")),
              "nothing is wrong");
    EXPECT_EQ(mistake(ball_with(9, "radius = \"n*i\"\nn = 2\ni = 0.5")), "nothing is wrong");
    EXPECT_THAT(mistake(blobs("count = 2\nx = \"i\"\n[parameters]\nn = 2")),
                testing::HasSubstr("'n' means the number of elements"));
}

// The caret stands below its line of the formula, and the place is that of the key.
TEST_F(ExpressionMistakes, FormulasOfSeveralLines) {
    EXPECT_EQ(mistake(ball_with(6, "formula = \"\"\"\na = x^2 + y^2;\na + z^2 - radiuss\n\"\"\"")),
              "scene.toml:6: surface.formula: unknown name 'radiuss'; did you mean 'radius'?\n"
              "    a + z^2 - radiuss\n"
              "              ^");
}

TEST_F(ExpressionMistakes, Parameters) {
    expect({
        {ball_with(9, "radius = \"1 + tt\""),
         "scene.toml:9: parameters.radius: unknown name 'tt'; did you mean 't'?\n"
         "    1 + tt\n"
         "        ^"},
        {ball_with(9, "radius = \"1/(2 - 2)\""),
         "scene.toml:9: parameters.radius: division by zero\n"
         "    1/(2 - 2)\n"
         "     ^"},
        {ball_with(9, "radius = \"x\""),
         "scene.toml:9: parameters.radius: unknown name 'x'; known: t, radius, pi\n"
         "    x\n"
         "    ^"},
        {ball_with(9, "radius = \"2*radius\""),
         "scene.toml:9: parameters.radius: the value of 'radius' depends on itself"},
        {ball_with(9, "radius = \"1 +\""),
         "scene.toml:9: parameters.radius: the formula ends where a value is expected\n"
         "    1 +\n"
         "       ^"},
    });
    const std::string ring = mistake(ball_with(9, "radius = \"b\"\nb = \"c\"\nc = \"b + t\""));
    EXPECT_THAT(ring,
                testing::AnyOf("scene.toml:10: parameters.b: the value of 'b' depends on itself",
                               "scene.toml:11: parameters.c: the value of 'c' depends on itself"));
}

// Every number that may move, with a name in it that there isn't.
TEST_F(ExpressionMistakes, EveryOtherNumberThatMoves) {
    const auto unknown = [](const std::string& place) {
        return place + ": unknown name 'q'; known: t, radius, pi\n    q\n    ^";
    };
    expect({
        {ball_with(7, "bounds = { sphere = \"q\" }"),
         unknown("scene.toml:7: surface.bounds.sphere")},
        {ball_with(7, "bounds = { sphere = 1, centre = [0, \"q\", 0] }"),
         unknown("scene.toml:7: surface.bounds.centre.y")},
        {ball_with(7, "bounds = { box = [[0, 0, 0],\n[1, 1, \"q\"]] }"),
         unknown("scene.toml:8: surface.bounds.box.max.z")},
        {ball_with(7, "bounds = { sphere = 1 }\ntransform = { translate = [\"q\", 0, 0] }"),
         unknown("scene.toml:8: surface.transform.translate.x")},
        {ball_with(7, "bounds = { sphere = 1 }\ntransform = { rotate = [0, 0, \"q\"] }"),
         unknown("scene.toml:8: surface.transform.rotate.z")},
        {ball_with(7, "bounds = { sphere = 1 }\ntransform = { scale = \"q\" }"),
         unknown("scene.toml:8: surface.transform.scale")},
        {ball_with(11, "position = [4, 0, \"q\"]"), unknown("scene.toml:11: camera.position.z")},
        {ball_with(12, "target = [4, 0, \"q\"]"), unknown("scene.toml:12: camera.target.z")},
        {ball_with(12, "up = [\"q\", 0, 1]"), unknown("scene.toml:12: camera.up.x")},
        {ball_with(12, "fov = \"q\""), unknown("scene.toml:12: camera.fov")},
        {ball_and("[[lights]]\ndirection = [\"q\", 0, 1]"),
         unknown("scene.toml:16: lights[0].direction.x")},
        {ball_and("[[lights]]\ndirection = [0, 0, 1]\n[[lights]]\ndirection = [0, 0, 1]\ncolor = "
                  "[1, 1, \"q\"]"),
         unknown("scene.toml:19: lights[1].color.z")},
        {ball_and("[material]\nback_color = [1, \"q\", 1]"),
         unknown("scene.toml:16: material.back_color.y")},
    });
}

} // namespace
} // namespace isomotion::scene
