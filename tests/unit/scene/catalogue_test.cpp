#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

// Two parameters, an array with a field of each kind, and settings of its own.
const char* const knot = R"toml(title = "Knot"
source = "nowhere"
formula = "sum(balls, w*exp(-k*((x-cx)^2 + (y-cy)^2 + z^2))) - m"
bounds = { sphere = "1 + m" }
[parameters]
k = { default = 6, min = 0.5, max = 20 }
m = 0.5
[arrays.balls]
count = 3
cx = [1, 2, 3]
cy = "0.1*i"
w = 1
[isolation]
method = "marching"
step = 0.25
near = 0.125
)toml";

class Catalogue : public Scenes {
protected:
    Catalogue() { surface("knot", knot); }
    Scene used(const std::string& more = "", const std::vector<Override>& overrides = {}) const {
        return loaded(use + more, overrides);
    }
    static constexpr const char* use = "[surface]\nuse = \"knot\"\n";
    std::string with(const std::string& more) const { return use + more; }

    float parameter(const Scene& scene, const std::string& name, double time = 0) const {
        const auto track = scene.surfaces[0].animation.find(name).value();
        EXPECT_LT(track, scene.surfaces[0].parameters) << name;
        return at_time(scene, time).surfaces[0].bindings.parameters.at(std::size_t(track));
    }
    std::vector<float> column(const Scene& scene, std::size_t field) const {
        return at_time(scene, 0).surfaces[0].bindings.arrays.at(0).fields.at(field);
    }
};

TEST_F(Catalogue, ASurfaceBringsEverythingAlong) {
    const Scene scene = used();
    EXPECT_EQ(scene.surfaces[0].name, "knot");
    EXPECT_EQ(scene.title, "scene"); // the title is the animation's
    EXPECT_EQ(parameter(scene, "k"), 6);
    EXPECT_EQ(parameter(scene, "m"), 0.5);
    EXPECT_EQ(at_time(scene, 0).surfaces[0].bounds.radius, 1.5);
    EXPECT_THAT(column(scene, 0), ElementsAre(1, 2, 3));
    EXPECT_THAT(column(scene, 1), ElementsAre(0, 0.1f, 0.2f));
    EXPECT_EQ(parameter(scene, "balls.w"), 1);
    EXPECT_EQ(scene.surfaces[0].isolation.method, Method::marching);
    EXPECT_EQ(scene.surfaces[0].isolation.step, 0.25);
    EXPECT_EQ(scene.surfaces[0].isolation.near, 0.125);
    EXPECT_GT(scene.surfaces[0].isolation.far, 0); // not in the file: from the field
}

TEST_F(Catalogue, ParametersOfTheSceneGoFirst) {
    const Scene scene = used("[parameters]\nk = \"8 + t\"\n");
    EXPECT_EQ(parameter(scene, "k", 1), 9);
    EXPECT_EQ(parameter(scene, "m", 1), 0.5);
    EXPECT_EQ(at_time(used("[parameters]\nm = 2\n"), 0).surfaces[0].bounds.radius, 3);
    EXPECT_EQ(parameter(used("", {"m=0.75"}), "m"), 0.75);
}

TEST_F(Catalogue, ParametersMayBeGivenByOthersOfTheScene) {
    const Scene scene = used("[parameters]\nk = \"2*speed\"\nspeed = 4\n");
    EXPECT_EQ(at_time(scene, 0).surfaces[0].bindings.parameters.at(0), 8);
}

TEST_F(Catalogue, FieldsOfTheSceneGoFirst) {
    const Scene scene = used("[arrays.balls]\ncy = 7\nw = \"i\"\n");
    EXPECT_THAT(column(scene, 0), ElementsAre(1, 2, 3));
    EXPECT_EQ(parameter(scene, "balls.cy"), 7);
    EXPECT_THAT(column(scene, 2), ElementsAre(0, 1, 2));
    EXPECT_THAT(column(used("[arrays.balls]\ncount = 2\ncx = [4, 5]\n"), 0), ElementsAre(4, 5));
}

TEST_F(Catalogue, SettingsAndBoundsOfTheSceneGoFirst) {
    const Scene scene = used("bounds = { box = [[-1, -1, -1], [1, 1, 1]] }\n"
                             "[isolation]\nstep = 0.5\nfar = 9\n");
    EXPECT_EQ(scene.surfaces[0].bounds.shape, Bounds::Shape::box);
    EXPECT_EQ(scene.surfaces[0].isolation.method, Method::marching);
    EXPECT_EQ(scene.surfaces[0].isolation.step, 0.5);
    EXPECT_EQ(scene.surfaces[0].isolation.near, 0.125);
    EXPECT_EQ(scene.surfaces[0].isolation.far, 9);
}

TEST_F(Catalogue, UnknownSurfacesAreToldTheNearestOrAll) {
    surface("superquadric", knot);
    EXPECT_EQ(mistake(ball_with(6, "use = \"superquadrik\"")),
              "scene.toml:6: surface.use: there is no surface 'superquadrik'; did you mean "
              "'superquadric'?");
    EXPECT_EQ(mistake(ball_with(6, "use = \"teapot\"")),
              "scene.toml:6: surface.use: there is no surface 'teapot'; known: knot, superquadric");
}

TEST_F(Catalogue, MistakesOfTheSceneAreTheScenes) {
    EXPECT_EQ(mistake(with("[parameters]\nkk = 2\n")),
              "scene.toml:4: parameters.kk: nothing uses this parameter; did you mean 'k'?");
    EXPECT_EQ(mistake(with("[arrays.balls]\ncount = 4\n")),
              "animations/surfaces/knot.toml:10: arrays.balls.cx: has 3 values for 4 elements; "
              "give one for each");
    EXPECT_EQ(mistake(with("[arrays.balls]\ncx = [1, 2]\n")),
              "scene.toml:4: arrays.balls.cx: has 2 values for 3 elements; give one for each");
    EXPECT_EQ(mistake(with("[arrays.balls]\ncxx = 2\n")),
              "scene.toml:4: arrays.balls.cxx: nothing uses this field; did you mean 'cx'?");
    EXPECT_THAT(mistake(with("[arrays.balls]\ncy = \"q\"\n")),
                StartsWith("scene.toml:4: arrays.balls.cy: unknown name 'q'"));
    EXPECT_THAT(mistake(with("formula = \"x\"\n")), StartsWith("scene.toml:3: surface.formula: "));
}

TEST_F(Catalogue, MistakesOfTheCatalogueAreTheCatalogues) {
    const auto broken = [&](const std::string& from, const std::string& to) {
        std::string text = knot;
        surface("knot", text.replace(text.find(from), from.size(), to));
        return mistake(use);
    };
    const std::string file = "animations/surfaces/knot.toml";
    EXPECT_THAT(broken("- m", "- mm"), StartsWith(file + ":3: formula: unknown name 'mm'"));
    EXPECT_EQ(broken("formula", "formulla"),
              file + ":1: formula: is missing; give the left side of F = 0\n" + file +
                  ":3: formulla: unknown key; did you mean 'formula'?");
    EXPECT_EQ(broken("title", "titel"), file + ":1: titel: unknown key; did you mean 'title'?");
    EXPECT_EQ(broken("default", "defualt"),
              file + ":6: parameters.k.defualt: unknown key; did you mean 'default'?\n" + file +
                  ":6: parameters.k: needs a default, or keys = [[t, value], ...]");
    EXPECT_EQ(broken("min =", "least ="),
              file + ":6: parameters.k.least: unknown key; known here: default, max, min");
    EXPECT_EQ(broken("max = 20", "max = \"20\""), file + ":6: parameters.k.max: must be a number");
    EXPECT_THAT(broken("\"0.1*i\"", "\"0.1*j\""),
                StartsWith(file + ":11: arrays.balls.cy: unknown name 'j'"));
    EXPECT_EQ(broken("step = 0.25", "step = -1"),
              file + ":15: isolation.step: must be from 1e-30 to 1e+30, not -1");
    EXPECT_THAT(broken("[isolation]", "[isolation"), StartsWith(file + ":13: not valid TOML: "));
}

TEST_F(Catalogue, ASurfaceWithoutBoundsAsksTheSceneForThem) {
    surface("plain", "formula = \"x^2 + y^2 + z^2 - 1\"\n");
    EXPECT_EQ(mistake("[surface]\nuse = \"plain\"\n"),
              "scene.toml:1: surface.bounds: is missing; give { sphere = radius } or { box = [[x0, "
              "y0, z0], [x1, y1, z1]] }");
    EXPECT_EQ(mistake("[surface]\nuse = \"plain\"\nbounds = { sphere = 2 }\n"), "nothing is wrong");
}

} // namespace
} // namespace isomotion::scene
