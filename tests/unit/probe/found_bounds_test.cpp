// Bounds of scenes that give none hold the surface and little else.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "probe/found_bounds.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"

namespace isomotion::probe {
namespace {

using namespace scene;

using testing::HasSubstr;

struct Body {
    const char* formula;
    glm::dvec3 centre;
    double radius; // of the smallest ball about it
};

void PrintTo(const Body& body, std::ostream* out) { *out << body.formula; }

class FoundBounds : public testing::TestWithParam<Body> {};

TEST_P(FoundBounds, HoldTheSurfaceAndLittleElse) {
    const auto& [formula, centre, radius] = GetParam();
    const Scene scene = load(formula);
    ASSERT_EQ(scene.surfaces[0].found_bounds, std::optional(true));
    const BoundsAt bounds = at_frame(scene, 1).surfaces[0].bounds;
    const auto& origin = scene.surfaces[0].field->origin.point;
    const glm::dvec3 middle = bounds.centre + glm::dvec3(origin[0], origin[1], origin[2]);
    EXPECT_GE(bounds.radius, radius + glm::length(middle - centre));
    EXPECT_LE(bounds.radius, 1.35 * radius);
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, FoundBounds,
    testing::Values(Body{"x^2 + y^2 + z^2 = 1", {}, 1}, Body{"x² + y² + z² = 0.0001", {}, 0.01},
                    Body{"(x-3)^2 + (y+2)^2 + z^2 = 4", {3, -2, 0}, 2},
                    Body{"x^2/81 + y^2 + z^2 = 1", {}, 9}, Body{"x^40 + y^40 + z^40 = 1", {}, 1.7},
                    Body{"|x| + |y| + |z| = 1", {}, 1},
                    Body{"max(|x|, |y|, |z|) = 1", {}, 1.7320508},
                    Body{"(sqrt(x^2 + y^2) - 1)^2 + z^2 = 0.04", {}, 1.2},
                    Body{"x^2 + y^2 + z^2 = 144", {}, 12}, Body{"x^2 + y^2 + z^2 = 1e12", {}, 1e6},
                    Body{"x^2 + y^2 + z^2 = 1e-12", {}, 1e-6},
                    Body{"(x-8)^2 + y^2 + z^2 = 4", {8, 0, 0}, 2},
                    Body{"(x-100)^2 + (y-50)^2 + z^2 = 1", {100, 50, 0}, 1},
                    Body{"(x-1e5)^2 + y^2 + (z+3e5)^2 = 4", {1e5, 0, -3e5}, 2},
                    Body{"x^2/9 + y^2/250000 + z^2 = 1", {}, 500},
                    Body{"max(|x - 40|, |y|, |z|) = 15", {40, 0, 0}, 25.98},
                    Body{"min((x-2)^2 + y^2 + z^2, (x+2)^2 + y^2 + z^2) = 0.01", {}, 2.1}));

TEST(FoundBoundsOf, WhatGoesOnIsABallThatIsSaid) {
    for (const char* formula :
         {"z = sin(x)", "x^2 + y^2 = 1", "x^2 + y^2 + z^2 = -1", "1/x = 0", "z = x^2 + y^2",
          "x*y*z = 1", "log(x) = y", "sin(x) + cos(y) + sin(z) = 0.1", "x^2 = 50 + y^2"}) {
        const Scene scene = load(formula);
        EXPECT_EQ(scene.surfaces[0].found_bounds, std::optional(false)) << formula;
        EXPECT_EQ(at_frame(scene, 1).surfaces[0].bounds.radius, 3) << formula;
    }
}

// Parts far from a first one belong to the surface; what goes on for ever is said.
TEST(FoundBoundsOf, PartsBeyondAreSaid) {
    const Scene two = load("min(length(x, y, z), length(x - 100, y, z)) = 1");
    EXPECT_EQ(two.surfaces[0].found_bounds, std::optional(true));
    EXPECT_GE(at_frame(two, 1).surfaces[0].bounds.radius, 51);
    EXPECT_LE(at_frame(two, 1).surfaces[0].bounds.radius, 60);
    const Scene plane = load("min(length(x, y, z) - 1, abs(x - 20))");
    EXPECT_EQ(plane.surfaces[0].found_bounds, std::optional(false));
    // A ball that is elsewhere after a second.
    const Scene jumping = load("length(x - 100*floor(t), y, z) = 1");
    const BoundsAt bounds = at_frame(jumping, 40).surfaces[0].bounds;
    EXPECT_GE(bounds.radius, glm::length(bounds.centre - glm::dvec3(100, 0, 0)) + 1);
}

TEST(FoundBoundsOf, WhatMovesAreOfAllFrames) {
    const Scene scene = load("(x - 4*sin(t))^2 + y^2 + z^2 = 0.25");
    EXPECT_EQ(scene.timeline.frames, 120);
    for (const int frame : {1, 48, 120}) {
        const SceneAt now = at_frame(scene, frame);
        const double x = 4 * std::sin((frame - 1) / 30.0);
        EXPECT_GE(now.surfaces[0].bounds.radius,
                  glm::length(now.surfaces[0].bounds.centre - glm::dvec3(x, 0, 0)) + 0.5);
        EXPECT_LE(now.surfaces[0].bounds.radius, 6);
    }
}

// Faster than any few frames tell.
TEST(FoundBoundsOf, WhatSwingsFastAreOfAllFrames) {
    const Scene scene = load("(x - 2*sin(47*t))^2 + (y - 2*cos(31*t))^2 + z^2 = 0.25");
    for (int frame = 1; frame <= 120; ++frame) {
        const SceneAt now = at_frame(scene, frame);
        const double t = (frame - 1) / 30.0;
        const glm::dvec3 middle(2 * std::sin(47 * t), 2 * std::cos(31 * t), 0);
        EXPECT_GE(now.surfaces[0].bounds.radius,
                  glm::length(now.surfaces[0].bounds.centre - middle) + 0.5)
            << frame;
    }
}

// The work that frames share is for what moves.
TEST(FoundBoundsOf, FramesOfWhatRestsAreOne) {
    const auto scene = [](int frames) {
        return load_text(fmt::format(R"toml([surface]
formula = "least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.2)"
[time]
frames = {}
fps = 30
[arrays.p]
count = 5000
cx = "2*random(i, 2) - 1"
cy = "2*random(i, 0) - 1"
cz = "2*random(i, 1) - 1"
[camera]
azimuth = "10*t"
)toml",
                                     frames),
                         "scene.toml");
    };
    const Scene one = scene(1), many = scene(80);
    ASSERT_EQ(one.surfaces[0].found_bounds, std::optional(true));
    EXPECT_EQ(many.surfaces[0].found_bounds, std::optional(true));
    EXPECT_EQ(at_frame(many, 80).surfaces[0].bounds.radius,
              at_frame(one, 1).surfaces[0].bounds.radius);
}

TEST(FoundBoundsOf, ElementsHoldThemOrAreTooMany) {
    const auto scene = [](int count) {
        return load_text(fmt::format(R"toml([surface]
formula = "least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.2)"
[time]
frames = 30
fps = 30
[arrays.p]
count = {}
cx = "2*sin(7*t + i)"
cy = "2*random(i, 0) - 1"
cz = "2*random(i, 1) - 1"
)toml",
                                     count),
                         "scene.toml");
    };
    const Scene few = scene(20);
    EXPECT_EQ(few.surfaces[0].found_bounds, std::optional(true));
    for (int frame = 1; frame <= 30; ++frame) {
        const SceneAt now = at_frame(few, frame);
        const auto& p = now.surfaces[0].bindings.arrays[0];
        for (std::size_t e = 0; e < 20; ++e) {
            const glm::dvec3 middle(p.fields[0][e], p.fields[1][e], p.fields[2][e]);
            EXPECT_GE(now.surfaces[0].bounds.radius,
                      glm::length(now.surfaces[0].bounds.centre - middle) + 0.2)
                << frame;
        }
    }
    try {
        scene(100'000);
        FAIL() << "no mistake";
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), HasSubstr("surface.bounds: is missing, and looking for"));
    }
}

// What moves by a setting alone, and what swings out between two frames.
TEST(FoundBoundsOf, WhatASettingMovesHoldIt) {
    const Scene drifting = load("(x - a)^2 + y^2 + z^2 = 1", {"a=2*t"});
    EXPECT_EQ(drifting.timeline.frames, 120);
    EXPECT_EQ(load("(x - a)^2 + y^2 + z^2 = 1", {"a=2"}).timeline.frames, 1);
    EXPECT_EQ(load("(x - a)^2 + y^2 + z^2 = 1", {"a=2*t", "time.seconds=2"}).timeline.frames, 60);
    EXPECT_EQ(load("(x - t)^2 + y^2 + z^2 = 1", {"time.frames=9"}).timeline.frames, 9);
    const Scene swinging = load("(x - a)^2 + y^2 + z^2 = 1", {"a=3*sin(60*pi*t)"});
    for (const Scene* scene : {&drifting, &swinging}) {
        ASSERT_TRUE(are_bounds_found(*scene));
        for (const double part : {0.0, 0.25, 0.5, 0.75}) {
            const SceneAt now = at_frame(*scene, 60, part);
            const double reach =
                glm::length(now.surfaces[0].bounds.centre -
                            glm::dvec3(now.surfaces[0].bindings.parameters.at(0), 0, 0));
            EXPECT_GE(now.surfaces[0].bounds.radius, reach + 1) << part;
        }
    }
}

TEST(WordOf, LoadsTheSceneAgain) {
    const Scene formula = load("x^2 + y^2 + z^2 = 1 + 0.1*sin(t)");
    EXPECT_EQ(reload_argument(formula), "x^2 + y^2 + z^2 = 1 + 0.1*sin(t)");
    EXPECT_EQ(load(reload_argument(formula)).title, formula.title);
    // Longer than any file's name.
    const std::string often = std::string("x^2") + std::string(600, ' ') + "+ y^2 + z^2 = 1";
    EXPECT_EQ(reload_argument(load(often)), often);
    const Scene file = load("torus");
    EXPECT_TRUE(std::filesystem::path(reload_argument(file)).is_absolute());
    EXPECT_EQ(load(reload_argument(file)).title, file.title);
}

TEST(FoundBoundsOf, AFormulaIsASceneWithParametersThatAreSet) {
    const Scene scene = load("x^2 + y^2 + z^2 = a", {"a=4"});
    EXPECT_NEAR(at_frame(scene, 1).surfaces[0].bounds.radius, 2.15, 0.15);
    EXPECT_EQ(scene.title, "x^2 + y^2 + z^2 = a");
    EXPECT_EQ(load("x^2 + y^2 + z^2 = 4", {"surface.bounds={sphere=7}"}).surfaces[0].found_bounds,
              std::nullopt);
    const auto mistake = [](const char* formula) -> std::string {
        try {
            load(formula);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "nothing is wrong";
    };
    EXPECT_EQ(mistake("x^2 = b"), "unknown name 'b'; known: x, y, z, pi\n    x^2 = b\n          ^\n"
                                  "--set b=1 makes it a parameter");
    EXPECT_THAT(mistake("blobby57"), HasSubstr("did you mean 'blobby75'"));
    EXPECT_THAT(mistake("(none).toml"), HasSubstr("no such file"));
}

} // namespace
} // namespace isomotion::probe
