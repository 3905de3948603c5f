#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::ElementsAre;

// Every section and every key there is.
const char* const everything = R"toml(
title = "Everything"
[time]
fps = "30000/1001"
frames = 120
seed = 5
[surface]
formula = "sum(blobs, w*exp(-k*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - m"
bounds = { sphere = "2 + t", centre = [0.5, 0, { keys = [[0, 1], [1, 3]] }] }
transform = { translate = [1, "2*t", 3], rotate = { keys = [[0, [0, 0, 0]], [2, [90, 0, 180]]], ease = "smooth" }, scale = 2 }
[parameters]
m = "0.5 + 0.1*t"
k = { keys = [[0, 4], [1, 8], [2, 2]], ease = "cubic" }
[arrays.blobs]
count = 3
cx = [-1, 0, 1]
cy = "cx*t"
cz = "random(i, 0)"
w = 1
[isolation]
method = "amp-taylor"
step = 0.015
near = 0.05
far = 0.5
horizon = 0.1
bisections = 12
limit = 5000
[camera]
position = [3, "2 + t", 1.5]
target = [0, 0, 1]
up = [0, 1, 0]
fov = "30 + 10*t"
[[lights]]
direction = [0, 0, 5]
color = [1, 0.5, 0.25]
[[lights]]
direction = ["3*t", 4, 0]
[material]
color = [0.8, "0.3*t", 0.2]
[output]
size = [640, 480]
background = [0.1, 0.2, 0.3]
)toml";

class Load : public Scenes {};

TEST_F(Load, EverySection) {
    const Scene scene = loaded(everything);
    EXPECT_EQ(scene.file, folder() / "scene.toml");
    EXPECT_EQ(scene.title, "Everything");
    EXPECT_EQ(scene.timeline.fps, (animation::FrameRate{30000, 1001}));
    EXPECT_EQ(scene.timeline.frames, 120);

    EXPECT_EQ(scene.surfaces[0].name, "");
    EXPECT_EQ(scene.surfaces[0].bounds.shape, Bounds::Shape::sphere);
    EXPECT_EQ(scene.surfaces[0].isolation.method, Method::amp_taylor);
    EXPECT_EQ(scene.surfaces[0].isolation.step, 0.015);
    EXPECT_EQ(scene.surfaces[0].isolation.near, 0.05);
    EXPECT_EQ(scene.surfaces[0].isolation.far, 0.5);
    EXPECT_EQ(scene.surfaces[0].isolation.horizon, 0.1);
    EXPECT_EQ(scene.surfaces[0].isolation.bisections, 12);
    EXPECT_EQ(scene.surfaces[0].isolation.limit, 5000);

    EXPECT_TRUE(scene.camera.position);
    EXPECT_EQ(scene.lights.size(), 2u);
    EXPECT_FALSE(scene.lights[0].headlight);
    EXPECT_EQ(scene.output.width, 640);
    EXPECT_EQ(scene.output.height, 480);
    EXPECT_THAT(scene.output.background, ElementsAre(0.1, 0.2, 0.3));
    EXPECT_FALSE(scene.output.transparent);
}

TEST_F(Load, WhatMovesIsReadAtItsTime) {
    const Scene scene = loaded(everything);
    const SceneAt now = at_time(scene, 1);
    EXPECT_EQ(now.time, 1);
    EXPECT_EQ(now.surfaces[0].bounds.radius, 3);
    EXPECT_EQ(now.surfaces[0].bounds.centre, glm::dvec3(0.5, 0, 3));
    EXPECT_EQ(now.surfaces[0].placement.translate, glm::dvec3(1, 2, 3));
    EXPECT_EQ(now.surfaces[0].placement.scale, 2);
    EXPECT_EQ(now.camera.position, glm::dvec3(3, 3, 1.5));
    EXPECT_EQ(now.camera.target, glm::dvec3(0, 0, 1));
    EXPECT_EQ(now.camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(now.camera.fov, 40);
    EXPECT_EQ(now.lights.at(0).direction, glm::dvec3(0, 0, 1));
    EXPECT_EQ(now.lights.at(0).color, glm::dvec3(1, 0.5, 0.25));
    EXPECT_LT(glm::length(now.lights.at(1).direction - glm::dvec3(0.6, 0.8, 0)), 1e-15);
    EXPECT_EQ(now.lights.at(1).color, glm::dvec3(1));
    EXPECT_EQ(now.surfaces[0].color, glm::dvec3(0.8, 0.3, 0.2));

    // Smooth keys of a vector: half way at half the time.
    const PlacementAt half = now.surfaces[0].placement;
    EXPECT_LT(glm::length(half.rotate * glm::dvec3(1, 0, 0) - glm::dvec3(0, 1, 0)), 1e-12);
    EXPECT_NE(at_time(scene, 0).surfaces[0].placement.rotate, half.rotate);
    EXPECT_EQ(at_time(scene, 0).surfaces[0].placement.rotate, glm::dmat3(1));

    ASSERT_EQ(now.surfaces[0].bindings.arrays.size(), 1u);
    EXPECT_EQ(now.surfaces[0].bindings.arrays[0].count, 3);
    EXPECT_THAT(now.surfaces[0].bindings.arrays[0].fields[0],
                ElementsAre(-1, 0, 1)); // sorted: cx, cy, cz
    EXPECT_THAT(now.surfaces[0].bindings.arrays[0].fields[1], ElementsAre(-1, 0, 1));
}

TEST_F(Load, TheSeedIsThatOfRandomNumbers) {
    const auto centres = [&](const std::string& seed) {
        const Scene scene = loaded(everything, {"time.seed=" + seed});
        return scene.surfaces[0].animation.at(0).arrays.at(0).fields.at(2);
    };
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(centres("5")[std::size_t(i)], formula::random_unit(5, i, 0));
    }
    EXPECT_NE(centres("5"), centres("6"));
}

TEST_F(Load, DefaultsOfTheSmallestScene) {
    const Scene scene = loaded("[surface]\n"
                               "formula = \"x^2 + y^2 + z^2 - 1\"\n"
                               "bounds = { sphere = 2 }\n");
    EXPECT_EQ(scene.title, "scene");
    EXPECT_EQ(scene.timeline.fps, (animation::FrameRate{30, 1}));
    EXPECT_EQ(scene.timeline.frames, 1);
    EXPECT_EQ(scene.surfaces[0].isolation.method, Method::hermite);
    EXPECT_EQ(scene.surfaces[0].isolation.safety, 32);
    EXPECT_FALSE(scene.surfaces[0].isolation.beam);
    EXPECT_EQ(scene.surfaces[0].isolation.step, 0.02); // a hundredth of the bounds' radius
    EXPECT_EQ(scene.surfaces[0].isolation.bisections, 10);
    EXPECT_EQ(scene.surfaces[0].isolation.limit, 100'000);
    EXPECT_GT(scene.surfaces[0].isolation.near, 0);
    EXPECT_GT(scene.surfaces[0].isolation.far, scene.surfaces[0].isolation.near);
    EXPECT_GT(scene.surfaces[0].isolation.horizon, 0);
    EXPECT_FALSE(scene.camera.position);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_TRUE(scene.lights[0].headlight);
    EXPECT_EQ(scene.output.width, 512);
    EXPECT_EQ(scene.output.height, 512);
    EXPECT_FALSE(scene.output.transparent);

    const SceneAt now = at_time(scene, 0);
    EXPECT_EQ(now.surfaces[0].bounds.centre, glm::dvec3(0));
    EXPECT_EQ(now.surfaces[0].placement.translate, glm::dvec3(0));
    EXPECT_EQ(now.surfaces[0].placement.rotate, glm::dmat3(1));
    EXPECT_EQ(now.surfaces[0].placement.scale, 1);
    EXPECT_EQ(now.camera.up, glm::dvec3(0, 0, 1));
    EXPECT_EQ(now.camera.fov, 40);
    EXPECT_EQ(now.lights[0].color, glm::dvec3(1));
}

TEST_F(Load, DefaultsOfACameraWithAPosition) {
    const SceneAt now = at_time(loaded(ball_with(12, "")), 0);
    EXPECT_EQ(now.camera.position, glm::dvec3(4, 0, 0));
    EXPECT_EQ(now.camera.target, glm::dvec3(0));
    EXPECT_EQ(now.camera.fov, 40);
}

TEST_F(Load, FrameRates) {
    const std::pair<const char*, animation::FrameRate> rates[] = {
        {"24", {24, 1}}, {"23.976", {2997, 125}},           {"25.0", {25, 1}},
        {"0.5", {1, 2}}, {"\"24000/1001\"", {24000, 1001}}, {"\"12\"", {12, 1}},
    };
    for (const auto& [text, rate] : rates) {
        EXPECT_EQ(loaded(ball_with(3, std::string("fps = ") + text)).timeline.fps, rate) << text;
    }
}

TEST_F(Load, TheBackgroundMayBeTransparent) {
    const Scene scene = loaded(ball_and("background = \"transparent\""));
    EXPECT_TRUE(scene.output.transparent);
    EXPECT_THAT(scene.output.background, ElementsAre(0, 0, 0));
}

TEST_F(Load, BoxesHaveTheirMiddleAndCircumscribedSphere) {
    const Scene scene =
        loaded(ball_with(7, "bounds = { box = [[-1, -2, \"-3 - t\"], [3, 2, 1]] }"));
    EXPECT_EQ(scene.surfaces[0].bounds.shape, Bounds::Shape::box);
    const BoundsAt bounds = at_time(scene, 1).surfaces[0].bounds;
    EXPECT_EQ(bounds.min, glm::dvec3(-1, -2, -4));
    EXPECT_EQ(bounds.max, glm::dvec3(3, 2, 1));
    EXPECT_EQ(bounds.centre, glm::dvec3(1, 0, -1.5));
    for (const glm::dvec3& corner : {bounds.min, bounds.max}) {
        EXPECT_DOUBLE_EQ(glm::length(corner - bounds.centre), bounds.radius);
    }
}

TEST_F(Load, ParametersComeFirstAmongTheTracks) {
    const Scene scene = loaded(everything);
    const auto& tracks = scene.surfaces[0].animation.tracks();
    // The formula's: k, m and the blobs' w, which is the same for every one of them.
    ASSERT_EQ(scene.surfaces[0].parameters, 3);
    EXPECT_EQ(tracks[0].name, "k");
    EXPECT_EQ(tracks[1].name, "m");
    EXPECT_EQ(tracks[2].name, "blobs.w");
    EXPECT_EQ(at_time(scene, 0).surfaces[0].bindings.parameters.size(), 3u);
}

TEST_F(Load, EveryMethodByItsName) {
    for (const MethodTraits& method : method_traits) {
        const std::string line = "[isolation]\nmethod = \"" + std::string(method.name) + "\"";
        EXPECT_EQ(loaded(ball_and(line)).surfaces[0].isolation.method, method.method);
        EXPECT_EQ(name(method.method), method.name);
    }
    EXPECT_EQ(parse_method("AMP"), std::nullopt);
}

} // namespace
} // namespace isomotion::scene
