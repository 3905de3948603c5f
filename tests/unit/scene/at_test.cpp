// A scene at one time: bindings and lights.
#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::ElementsAre;

class At : public Scenes {};

TEST_F(At, BindingsAreRoundedToFloatOnce) {
    const Scene scene = loaded(blobs("count = 2\ncx = [0.1, 16777217]\nw = 0.7"));
    const SceneAt now = at_time(scene, 0);
    EXPECT_THAT(now.surfaces[0].bindings.parameters, ElementsAre(0.7f));
    EXPECT_THAT(now.surfaces[0].bindings.arrays.at(0).fields.at(0), ElementsAre(0.1f, 16777216.0f));
    EXPECT_EQ(now.surfaces[0].bindings.arrays.at(0).count, 2);

    const Scene ratio = loaded(ball_with(9, "radius = \"1/3 + t/7\""));
    for (const double t : {0.0, 0.1, 2.5}) {
        EXPECT_THAT(at_time(ratio, t).surfaces[0].bindings.parameters,
                    ElementsAre(float(1.0 / 3 + t / 7)));
    }
}

TEST_F(At, CameraAndPlacementKeepTheirDoubles) {
    const Scene scene = loaded(ball_with(11, "position = [1000000.1, 0, 0]"));
    EXPECT_EQ(at_time(scene, 0).camera.position.x, 1000000.1);
}

TEST_F(At, ItIsTheSameEveryTime) {
    const Scene scene = loaded(ball_with(9, "radius = \"1 + 0.1*sin(t)\""));
    const SceneAt first = at_time(scene, 0.7);
    at_time(scene, 3);
    const SceneAt again = at_time(scene, 0.7);
    EXPECT_EQ(first.surfaces[0].bindings.parameters, again.surfaces[0].bindings.parameters);
    EXPECT_EQ(first.camera.position, again.camera.position);
    EXPECT_NE(first.surfaces[0].bindings.parameters,
              at_time(scene, 3).surfaces[0].bindings.parameters);
}

TEST_F(At, DirectionsToLightsHaveLengthOne) {
    const Scene scene = loaded(ball_and("[[lights]]\ndirection = [\"1e-9\", 2e-9, 2e-9]\n"
                                        "[[lights]]\ndirection = [0, -1e9, \"t\"]"));
    const SceneAt now = at_time(scene, 1);
    EXPECT_LT(glm::length(now.lights.at(0).direction - glm::dvec3(1, 2, 2) / 3.0), 1e-15);
    EXPECT_DOUBLE_EQ(glm::length(now.lights.at(1).direction), 1);
}

// What is given to the right, up and back is that wherever the camera stands.
TEST_F(At, ALightMayGoWithTheCamera) {
    for (const char* position : {"[4, 0, 0]", "[0, -4, 1]", "[-1, 2, -7]", "[0, 0, 3]"}) {
        std::string text = ball_with(11, std::string("position = ") + position);
        text += "[[lights]]\ndirection = [0.6, 0.8, 1]\nwith_camera = true\n"
                "[[lights]]\ndirection = [0, 0, \"2 + t\"]\nwith_camera = true\n";
        const SceneAt now = at_time(loaded(text), 1);
        const SceneAt plain =
            at_time(loaded(ball_with(11, std::string("position = ") + position)), 1);
        EXPECT_EQ(now.lights.at(0).direction, plain.lights.at(0).direction) << position;
        const glm::dvec3 back = glm::normalize(now.camera.position - now.camera.target);
        EXPECT_LT(glm::length(now.lights.at(1).direction - back), 1e-15) << position;
    }
    EXPECT_EQ(mistake(ball_and("[[lights]]\nposition = [1, 0, 0]\nwith_camera = true")),
              "scene.toml:17: lights[0].with_camera: is of a light with a direction: to the "
              "viewer's right, up and back");
}

// Without a light of its own a scene is lit from above the viewer's right shoulder.
TEST_F(At, TheHeadlightFollowsTheCamera) {
    for (const char* position : {"[4, 0, 0]", "[0, -4, 1]", "[-1, 2, -7]", "[1e6, 1e6, 0]"}) {
        const Scene scene = loaded(ball_with(11, std::string("position = ") + position));
        const SceneAt now = at_time(scene, 0);
        const glm::dvec3 light = now.lights.at(0).direction;
        const glm::dvec3 forward = now.camera.target - now.camera.position;
        EXPECT_LT(glm::dot(light, forward), 0) << position;
        const glm::dvec3 right = glm::cross(forward, now.camera.up);
        EXPECT_GT(glm::dot(light, right), 0) << position;
        EXPECT_GT(glm::dot(light, glm::cross(right, forward)), 0) << position;
        EXPECT_DOUBLE_EQ(glm::length(light), 1) << position;
    }
}

TEST_F(At, TheHeadlightShinesAlongUpToo) {
    for (const char* position : {"[0, 0, 5]", "[0, 0, -5]"}) {
        const SceneAt now =
            at_time(loaded(ball_with(11, std::string("position = ") + position)), 0);
        const glm::dvec3 back = glm::normalize(now.camera.position);
        EXPECT_DOUBLE_EQ(glm::length(now.lights.at(0).direction), 1);
        EXPECT_GT(glm::dot(now.lights.at(0).direction, back), 0.5);
    }
}

} // namespace
} // namespace isomotion::scene
