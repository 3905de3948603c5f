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

double parameter(const Surface& surface, const char* name) {
    const auto& animation = surface.animation;
    return animation.at(0).tracks[std::size_t(animation.find(name).value())];
}

// As it was set, since no line tells which surface it is of.
TEST(Surfaces, MistakesThatWereSetNameTheirSurface) {
    EXPECT_EQ(message_of(two, {"surfaces.ball.material.colour=[1, 0, 0]"}),
              "--set: surfaces.ball.material.colour: unknown key; did you mean 'color'?");
    EXPECT_THAT(message_of(two, {"surfaces.2.transform.scale='x'"}),
                HasSubstr("--set: surfaces.ring.transform.scale: "));
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
    EXPECT_EQ(place_of({scene, 0}, "surface.formula"), "scene.toml:3: surfaces.ball.formula");
    EXPECT_EQ(place_of({scene, 1}, "material.color"),
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
        EXPECT_EQ(at_frame(scene, 1).surfaces[0].bounds.radius, 3);
    }
    const Scene back = read(two, {"surfaces.ball.bounds.box=[[-1, -1, -1], [1, 1, 1]]"});
    EXPECT_EQ(back.surfaces[0].bounds.shape, Bounds::Shape::box);
    // A key by its former name.
    const Scene moved = read(two, {"surfaces.ring.placement.scale=3"});
    EXPECT_EQ(at_frame(moved, 1).surfaces[1].placement.scale, 3);
    EXPECT_THAT(read(two, {"surfaces.ring.material.inside=[0, 0, 1]"}).surfaces[1].material.inside,
                testing::Ne(std::nullopt));
}

TEST(Surfaces, HaveTheirOwnAndWhatTheyShare) {
    const Scene scene = read(two);
    EXPECT_THAT(surface_names(scene), ElementsAre("ball", "ring"));
    ASSERT_EQ(scene.surfaces.size(), 2);
    const Surface &ball = scene.surfaces[0], &ring = scene.surfaces[1];
    EXPECT_EQ(parameter(ball, "r"), 1);
    EXPECT_EQ(parameter(ring, "a"), 0.2);
    EXPECT_EQ(parameter(ring, "c"), 1.5); // shared, before the catalogue's
    EXPECT_EQ(ball.isolation.method, Method::hermite);
    EXPECT_EQ(ring.isolation.method, Method::interval);
    const SceneAt now = at_frame(scene, 1);
    EXPECT_EQ(now.surfaces[0].color, glm::dvec3(1, 0, 0));
    EXPECT_EQ(now.surfaces[1].color, glm::dvec3(0, 1, 0));
    EXPECT_EQ(now.surfaces[1].placement.scale, 2);
}

// Reading takes as long as all of them together.
TEST(Surfaces, FormulasAreLimitedTogether) {
    std::string long_one = "s = x; ";
    for (int k = 0; k < 9'000; ++k) long_one += fmt::format("s = s + 0.001*sin({}*y); ", k);
    std::string text;
    for (int k = 0; k < 3; ++k)
        text += "[[surfaces]]\nformula = '" + long_one + "s'\nbounds = { sphere = 1 }\n";
    try {
        load_text(text, "long.toml");
        FAIL() << "nothing was refused";
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("surfaces.3.formula: this formula and those "
                                                     "before it have more than 100000"));
    }
}

TEST(Surfaces, AreAllProvedOrNone) {
    EXPECT_FALSE(read(two).surfaces[0].isolation.certify);
    const Scene scene = read(two, {"surfaces.ring.isolation.certify=true"});
    EXPECT_TRUE(scene.surfaces[0].isolation.certify);
    EXPECT_TRUE(scene.surfaces[1].isolation.certify);
}

TEST(Surfaces, TheCameraSeesAll) {
    const Scene scene = read(two);
    const SceneAt now = at_frame(scene, 1);
    const double slope = std::sin(glm::radians(0.5 * now.camera.fov));
    const double way = glm::length(now.camera.target - now.camera.position);
    for (const SurfaceAt& surface : now.surfaces) {
        const glm::dvec3 middle = surface.placement.to_world(surface.bounds.centre);
        const double reach = glm::length(middle - now.camera.target) +
                             surface.bounds.radius * surface.placement.scale;
        EXPECT_LE(reach, way * slope * (1 + 1e-9));
    }
}

TEST(Surfaces, OneInTheListIsASceneOfOne) {
    const Scene scene = read("[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\n");
    EXPECT_EQ(scene.surfaces.size(), 1);
}

TEST(Surfaces, AreSetByNameAndNumber) {
    EXPECT_EQ(parameter(read(two, {"size=4"}).surfaces[0], "r"), 2);
    EXPECT_EQ(parameter(read(two, {"a=0.25"}).surfaces[1], "a"), 0.25);
    EXPECT_EQ(parameter(read(two, {"r=3*size"}).surfaces[0], "r"), 6);
    EXPECT_EQ(parameter(read(two, {"surfaces.ring.parameters.a=0.3"}).surfaces[1], "a"), 0.3);
    EXPECT_EQ(parameter(read(two, {"surfaces.2.parameters.a=0.4"}).surfaces[1], "a"), 0.4);
    const Scene moved = read(two, {"surfaces.ring.transform.scale=3"});
    EXPECT_EQ(at_frame(moved, 1).surfaces[1].placement.scale, 3);
    EXPECT_THAT(message_of(two, {"surfaces.rung.jumps=true"}), HasSubstr("name or the number"));
}

TEST(Surfaces, OneAloneIsASceneOfItsOwn) {
    const Scene scene = read(two);
    const Scene ring = alone({scene, surface_named(scene, "ring")});
    EXPECT_EQ(surface_names(ring), std::vector<std::string>{"ring"});
    EXPECT_NO_THROW(at_frame(ring, 1));
    EXPECT_THROW(surface_named(scene, "rung"), SceneError);
}

// Each surface's animation has the tracks of what all share, at other places.
TEST(Surfaces, OneAloneIsSeenAsItWas) {
    const std::string shared =
        "[camera]\nposition = [3, '-9 + t', 2]\nup = [0, 1, 1]\nfov = 31\naperture = 0.1\n"
        "[[lights]]\nposition = ['t', 2, 3]\nfalloff = 2\nradius = 0.5\ncolor = [1, 0.5, 0]\n"
        "[[sections]]\nnormal = [1, 2, 3]\noffset = 't'\n[[sections]]\nsphere = 0.25\n"
        "centre = [1, 0, 't']\n[ground]\nheight = -3\n[fog]\ndensity = 0.2\nstart = 1\n"
        "[ambient]\ntop = [0.1, 0.2, 0.3]\n[occlusion]\nradius = 0.7\nstrength = 0.5\n";
    // A section leaves some of its tracks unset. These must not be looked up: the second surface
    // lacks the first one's first track.
    const Scene other =
        read("[[surfaces]]\nformula = 'x^2 + y^2 + z^2 - a'\nparameters = { a = 1 }\n"
             "bounds = { sphere = 2 }\n[[surfaces]]\nformula = 'x'\n"
             "bounds = { box = [[-1, -1, -1], [1, 1, 1]] }\n" +
             shared);
    EXPECT_EQ(packed(at(alone({other, 1}), 0.25).sections), packed(at(other, 0.25).sections));
    const Scene scene = read(two + shared);
    const SceneAt all = at(scene, 0.25);
    for (const std::size_t k : {0, 1}) {
        SCOPED_TRACE(k);
        const SceneAt one = at(alone({scene, k}), 0.25);
        EXPECT_EQ(one.surfaces[0].placement.scale, all.surfaces[k].placement.scale);
        EXPECT_EQ(one.camera, all.camera);
        ASSERT_EQ(one.lights.size(), 1);
        EXPECT_EQ(one.lights[0].direction, all.lights[0].direction);
        EXPECT_EQ(one.lights[0].color, glm::dvec3(1, 0.5, 0));
        EXPECT_EQ(one.lights[0].falloff, 2);
        EXPECT_EQ(one.lights[0].radius, 0.5);
        EXPECT_EQ(packed(one.sections), packed(all.sections));
        EXPECT_EQ(one.ground.height, -3);
        EXPECT_EQ(one.fog.density, 0.2);
        EXPECT_EQ(one.fog.start, 1);
        EXPECT_EQ(one.ambient.top, glm::dvec3(0.1, 0.2, 0.3));
        EXPECT_EQ(one.occlusion.reach, 0.7);
        EXPECT_EQ(one.occlusion.strength, 0.5);
    }
}

// A scene of several is never taken for its first surface.
TEST(Surfaces, AreNamedWhereOneOfSeveralIsMeant) {
    const Scene scene = read(two);
    EXPECT_THROW(OneSurface{scene}, std::logic_error);
    EXPECT_THROW(OneSurfaceAt{at_frame(scene, 1)}, std::logic_error);
    EXPECT_THROW((OneSurface{scene, 2}), std::out_of_range);
    EXPECT_EQ(OneSurface(alone({scene, 1})).surface.label, "ring");
}

TEST(Surfaces, MistakesHaveTheirLine) {
    const std::string ball = "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\n";
    EXPECT_THAT(message_of(ball + "[[surfaces]]\nformula = \"x +\"\n"), HasSubstr("scene.toml:4:"));
    EXPECT_THAT(message_of(ball + "colour = 1\n"), HasSubstr("scene.toml:3: surfaces.1.colour"));
    EXPECT_THAT(message_of(ball + "name = \"\"\n"), HasSubstr("surfaces.1.name"));
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
    now.surfaces[0].placement.translate = {7, 1, 2}; // of the first
    now.surfaces[0].placement.scale = 0.5;
    const SceneAt there = in_formula_coordinates(now);
    for (const glm::dvec3 place : {glm::dvec3(0), glm::dvec3(1, 2, 3)}) {
        const glm::dvec3 world = now.surfaces[1].placement.to_world(place);
        const glm::dvec3 moved = there.surfaces[1].placement.to_world(place);
        EXPECT_LT(glm::length(now.surfaces[0].placement.to_local(world) - moved), 1e-12);
    }
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
    EXPECT_THAT(matters(scene), ElementsAre(2, 0, 4, 3));
    EXPECT_EQ(depth_of_matters(scene), 7);
    EXPECT_TRUE(matters(read(two)).empty());
    EXPECT_EQ(mirrors(read(two)), 0);
    EXPECT_EQ(mirrors(read(two, {"surfaces.ring.material.reflection=self"})), 2);
}

// Absorption is per world unit, and in the first one's coordinates per unit of these.
TEST(Surfaces, AbsorptionOfAllIsPerUnitOfTheCoordinates) {
    const std::string one =
        "[[surfaces]]\nformula = \"x\"\nbounds = { sphere = 1 }\ntransform = { "
        "scale = 4 }\nmaterial = { transmission = 1, absorption = [0.5, 0, 1] }\n";
    const Scene scene = read(one + one);
    const SceneAt world = at(scene, 0);
    const SceneAt now = in_formula_coordinates(world);
    EXPECT_EQ(world.surfaces[1].glass.absorption, glm::dvec3(0.5, 0, 1));
    EXPECT_EQ(now.surfaces[0].glass.absorption, glm::dvec3(2, 0, 4));
    EXPECT_EQ(now.surfaces[1].glass.absorption, glm::dvec3(2, 0, 4));
}

} // namespace
} // namespace isomotion::scene::surfaces_test
