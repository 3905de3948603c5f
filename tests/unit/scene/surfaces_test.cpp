// Several surfaces of a scene file: what is their own, what they share, and what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "scene/error.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"
#include "scene/surfaces.h"

namespace isomotion::scene::surfaces_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene read(const std::string& text, const std::vector<Override>& overrides = {}) {
    return load_text(text, "scene.toml", overrides);
}

std::string message_of(const std::string& text, const std::vector<Override>& overrides = {}) {
    try {
        read(text, overrides);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

const std::string two = R"([[surfaces]]
name = "ball"
formula = "x^2 + y^2 + z^2 - r^2"
bounds = { sphere = 2 }
parameters = { r = "0.5*size" }
[[surfaces]]
name = "ring"
use = "torus"
parameters = { a = 0.2 }
transform = { translate = [5, 0, 0], scale = 2 }
isolation = { method = "interval" }
material = { color = [0, 1, 0] }
[parameters]
size = 2
c = 1.5
[material]
color = [1, 0, 0]
)";

double parameter(const Scene& scene, const char* name) {
    const auto& animation = scene.surface.animation;
    return animation.at(0).tracks[std::size_t(animation.find(name).value())];
}

// As it was set, since no line tells which surface it is of.
TEST(Surfaces, MistakesThatWereSetNameTheirSurface) {
    EXPECT_EQ(message_of(two, {"surfaces.ball.material.colour=[1, 0, 0]"}),
              "--set: surfaces.ball.material.colour: unknown key; did you mean 'color'?");
    EXPECT_THAT(message_of(two, {"surfaces.2.transform.scale='x'"}),
                HasSubstr("--set: surfaces.2.transform.scale: "));
    EXPECT_THAT(message_of(two, {"surfaces.ball.formula=x +"}),
                HasSubstr("--set: surfaces.ball.formula: "));
    EXPECT_THAT(message_of(two, {"surfaces.2.arrays.p.count=3"}),
                HasSubstr("--set: surfaces.ring.arrays.p.count: no formula and no colour sums"));
    EXPECT_THAT(message_of(two, {"arrays.p.count=3"}), HasSubstr("--set: arrays.p.count: no "));
    EXPECT_EQ(message_of(two, {"material.colour=[1, 0, 0]"}),
              "--set: material.colour: unknown key; did you mean 'color'?");
}

TEST(Surfaces, PlacesNameTheSurface) {
    const Scene scene = read(two);
    EXPECT_EQ(place_of(scene, "surface.formula"), "scene.toml:3: surfaces.ball.formula");
    EXPECT_EQ(place_of(scene.others[0], "material.color"),
              "scene.toml:12: surfaces.ring.material.color");
    const Scene one = read("[surface]\nformula = 'x'\nbounds = { sphere = 1 }\n");
    EXPECT_EQ(place_of(one, "surface.formula"), "scene.toml:2: surface.formula");
    EXPECT_EQ(place_of(one, "material.color"), "scene.toml: material.color");
}

// What --set gives of a surface takes the place of what excludes it, as of a scene of one.
TEST(Surfaces, SettingsReplaceWhatExcludesThem) {
    std::string boxed = two;
    boxed.replace(boxed.find("{ sphere = 2 }"), 14, "{ box = [[-2, -2, -2], [2, 2, 2]] }");
    for (const char* name : {"ball", "1"}) {
        const Scene scene = read(boxed, {fmt::format("surfaces.{}.bounds.sphere=3", name)});
        EXPECT_EQ(at_frame(scene, 1).surface.bounds.radius, 3);
    }
    const Scene back = read(two, {"surfaces.ball.bounds.box=[[-1, -1, -1], [1, 1, 1]]"});
    EXPECT_EQ(back.surface.bounds.shape, Bounds::Shape::box);
    // A key by its former name.
    const Scene moved = read(two, {"surfaces.ring.placement.scale=3"});
    EXPECT_EQ(at_frame(moved, 1).others[0].surface.placement.scale, 3);
    EXPECT_THAT(
        read(two, {"surfaces.ring.material.inside=[0, 0, 1]"}).others[0].surface.material.inside,
        testing::Ne(std::nullopt));
}

TEST(Surfaces, HaveTheirOwnAndWhatTheyShare) {
    const Scene scene = read(two);
    EXPECT_THAT(surface_names(scene), ElementsAre("ball", "ring"));
    ASSERT_EQ(scene.others.size(), 1);
    const Scene& ring = scene.others[0];
    EXPECT_EQ(scene.among.count, 2);
    EXPECT_EQ(ring.among.index, 1);
    EXPECT_EQ(parameter(scene, "r"), 1);
    EXPECT_EQ(parameter(ring, "a"), 0.2);
    EXPECT_EQ(parameter(ring, "c"), 1.5); // shared, before the catalogue's
    EXPECT_EQ(scene.surface.isolation.method, Method::hermite);
    EXPECT_EQ(ring.surface.isolation.method, Method::interval);
    const SceneAt now = at_frame(scene, 1);
    EXPECT_EQ(now.surface.color, glm::dvec3(1, 0, 0));
    EXPECT_EQ(now.others[0].surface.color, glm::dvec3(0, 1, 0));
    EXPECT_EQ(now.others[0].surface.placement.scale, 2);
}

TEST(Surfaces, AreAllProvedOrNone) {
    EXPECT_FALSE(read(two).surface.isolation.certify);
    const Scene scene = read(two, {"surfaces.ring.isolation.certify=true"});
    EXPECT_TRUE(scene.surface.isolation.certify);
    EXPECT_TRUE(scene.others[0].surface.isolation.certify);
}

TEST(Surfaces, TheCameraSeesAll) {
    const Scene scene = read(two);
    const SceneAt now = at_frame(scene, 1);
    const SceneAt& ring = now.others[0];
    EXPECT_EQ(now.camera, ring.camera);
    const double slope = std::sin(glm::radians(0.5 * now.camera.fov));
    const double way = glm::length(now.camera.target - now.camera.position);
    for (const SceneAt* surface : {&now, &ring}) {
        const glm::dvec3 middle =
            surface->surface.placement.to_world(surface->surface.bounds.centre);
        const double reach = glm::length(middle - now.camera.target) +
                             surface->surface.bounds.radius * surface->surface.placement.scale;
        EXPECT_LE(reach, way * slope * (1 + 1e-9));
    }
}

TEST(Surfaces, OneInTheListIsASceneOfOne) {
    const Scene scene = read("[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\n");
    EXPECT_TRUE(scene.others.empty());
    EXPECT_EQ(scene.among.count, 1);
    EXPECT_NO_THROW(expect_one_surface(scene, "a page"));
}

TEST(Surfaces, AreSetByNameAndNumber) {
    EXPECT_EQ(parameter(read(two, {"size=4"}), "r"), 2);
    EXPECT_EQ(parameter(read(two, {"a=0.25"}).others[0], "a"), 0.25);
    EXPECT_EQ(parameter(read(two, {"r=3*size"}), "r"), 6);
    EXPECT_EQ(parameter(read(two, {"surfaces.ring.parameters.a=0.3"}).others[0], "a"), 0.3);
    EXPECT_EQ(parameter(read(two, {"surfaces.2.parameters.a=0.4"}).others[0], "a"), 0.4);
    const Scene moved = read(two, {"surfaces.ring.transform.scale=3"});
    EXPECT_EQ(at_frame(moved, 1).others[0].surface.placement.scale, 3);
    EXPECT_THAT(message_of(two, {"surfaces.rung.jumps=true"}), HasSubstr("name or the number"));
}

TEST(Surfaces, OneAloneIsASceneOfItsOwn) {
    const Scene scene = read(two);
    const Scene ring = alone(scene, surface_named(scene, "ring"));
    EXPECT_TRUE(ring.others.empty());
    EXPECT_EQ(ring.among.count, 1);
    EXPECT_NO_THROW(at_frame(ring, 1));
    EXPECT_THROW(surface_named(scene, "rung"), SceneError);
    try {
        expect_one_surface(scene, "a page");
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), HasSubstr("2 surfaces (ball, ring), and a page knows one"));
    }
}

TEST(Surfaces, MistakesHaveTheirLine) {
    const std::string ball = "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\n";
    EXPECT_THAT(message_of(ball + "[[surfaces]]\nformula = \"x +\"\n"), HasSubstr("scene.toml:4:"));
    EXPECT_THAT(message_of(ball + "colour = 1\n"), HasSubstr("scene.toml:3: surfaces[1].colour"));
    EXPECT_THAT(message_of(ball + "name = \"\"\n"), HasSubstr("surfaces[1].name"));
    EXPECT_THAT(message_of(ball + ball + "name = \"1\"\n"), HasSubstr("name of another"));
    EXPECT_THAT(message_of(ball + "[surface]\nformula = \"x\"\n"),
                HasSubstr("beside [[surfaces]]"));
    EXPECT_THAT(message_of(ball + ball + "[parameters]\nm = 1\n"),
                HasSubstr("parameters.m: no surface's formula"));
    EXPECT_THAT(message_of(ball + ball + "parameters = { m = 1 }\n"),
                HasSubstr("uses this parameter"));
    EXPECT_THAT(message_of("surfaces = 3\n"), HasSubstr("[[surfaces]] above"));
    std::string many;
    for (int k = 0; k < 9; ++k) many += ball;
    EXPECT_THAT(message_of(many), HasSubstr("at most 8"));
}

TEST(Surfaces, AreWhereTheFirstOneHasThem) {
    const Scene scene = read(two + "[camera]\nposition = [3, -9, 2]\n");
    SceneAt now = at_frame(scene, 1);
    now.surface.placement.translate = {7, 1, 2}; // of the first
    now.surface.placement.scale = 0.5;
    const SceneAt there = in_formula_coordinates(now);
    for (const glm::dvec3 place : {glm::dvec3(0), glm::dvec3(1, 2, 3)}) {
        const glm::dvec3 world = now.others[0].surface.placement.to_world(place);
        const glm::dvec3 moved = there.others[0].surface.placement.to_world(place);
        EXPECT_LT(glm::length(now.surface.placement.to_local(world) - moved), 1e-12);
    }
    EXPECT_EQ(there.others[0].camera, there.camera);
}

// The matter with the highest priority counts before all others, of equal ones the first in the
// file.
TEST(Surfaces, MattersAreInTheOrderOfTheirPriority) {
    std::string text;
    const std::string materials[] = {"transmission = 1", "color = [1, 0, 0]",
                                     "transmission = 1, priority = 3, depth = 7",
                                     "transmission = 0, priority = -2", "transmission = 1"};
    for (const std::string& material : materials)
        text += "[[surfaces]]\nformula = \"x\"\nbounds = { sphere = 1 }\nmaterial = { " + material +
                " }\n";
    const Scene scene = read(text);
    for (int k = 0; k < 5; ++k) {
        const Among among = of_surface(scene, k).among;
        EXPECT_THAT(among.matters, ElementsAre(2, 0, 4, 3)) << k;
        EXPECT_EQ(among.depth, 7) << k;
        EXPECT_EQ(among.index, k);
    }
    EXPECT_TRUE(of_surface(read(two), 1).among.matters.empty());
    // Alone there is no other to count before.
    EXPECT_TRUE(alone(scene, 2).among.matters.empty());
}

// Absorption is per world unit, and in the first one's coordinates per unit of these.
TEST(Surfaces, AbsorptionOfAllIsPerUnitOfTheCoordinates) {
    const std::string one =
        "[[surfaces]]\nformula = \"x\"\nbounds = { sphere = 1 }\ntransform = { "
        "scale = 4 }\nmaterial = { transmission = 1, absorption = [0.5, 0, 1] }\n";
    const Scene scene = read(one + one);
    const SceneAt world = at(scene, 0);
    const SceneAt now = in_formula_coordinates(world);
    EXPECT_EQ(world.others[0].surface.glass.absorption, glm::dvec3(0.5, 0, 1));
    EXPECT_EQ(now.surface.glass.absorption, glm::dvec3(2, 0, 4));
    EXPECT_EQ(now.others[0].surface.glass.absorption, glm::dvec3(2, 0, 4));
}

} // namespace
} // namespace isomotion::scene::surfaces_test
