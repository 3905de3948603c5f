// Files of Surfer as scenes.
#include "testing.h"

#include "scene/reading/surfer.h"
#include "scene/scene_at.h"

namespace isomotion::scene {
namespace {

using testing::HasSubstr;

constexpr const char* surfer_ball = R"(#jSurfer surface description
camera_type=ORTHOGRAPHIC_CAMERA
surface_parameter_a=0.25
surface_parameter_b=7
light_position_0=0.0 0.0 100.0
light_color_0=1.0 1.0 1.0
light_intensity_0=0.5
light_status_0=ON
light_status_1=OFF
front_material_color=1.0 0.5 0.0
back_material_color=0.0 0.0 1.0
background_color=1.0 1.0 1.0
scale_factor=0.30103
rotation_matrix=0 0 1 0  1 0 0 0  0 1 0 0  0 0 0 1
camera_height=2.0
surface_equation=x^2+y^2+z^2\
   -1*a
camera_transform=1 0 0 0 0 1 0 0 0 0 1 -1 0 0 0 1
)";

std::string with(const std::string& line, const std::string& instead) {
    std::string text = surfer_ball;
    return text.replace(text.find(line), line.size(), instead);
}

Scene scene_of(const std::string& text) { return load_text(text, "ball.jsurf"); }

std::string mistake_of(const std::string& text) { return mistake_of_text(text, "ball.jsurf"); }

TEST(Surfer, FormulaParametersAndBounds) {
    const Scene scene = scene_of(surfer_ball);
    EXPECT_EQ(scene.surfaces[0].field->text, "x^2+y^2+z^2-1*a");
    EXPECT_EQ(scene.title, "ball");
    const SceneAt now = at_frame(scene, 1);
    EXPECT_EQ(now.surfaces[0].bindings.parameters.front(), 0.25);
    EXPECT_NEAR(now.surfaces[0].bounds.radius, 2, 1e-5);
}

// The matrix takes the viewer's axes to the surface's: its columns are what is right, up and back.
TEST(Surfer, TheCameraAndTheLightsTurnInsteadOfTheSurface) {
    const Scene scene = scene_of(surfer_ball);
    const auto values = scene.surfaces[0].animation.at(scene.timeline.time(1));
    const auto vector = [&](const Vec3Track& track) {
        return glm::dvec3(values.tracks[std::size_t(track[0])],
                          values.tracks[std::size_t(track[1])],
                          values.tracks[std::size_t(track[2])]);
    };
    EXPECT_EQ(scene.camera.projection, Camera::Projection::orthographic);
    EXPECT_NEAR(glm::length(vector(*scene.camera.position) - glm::dvec3(6, 0, 0)), 0, 1e-4);
    EXPECT_NEAR(glm::length(vector(*scene.camera.target)), 0, 1e-4);
    EXPECT_EQ(vector(scene.camera.up), glm::dvec3(0, 0, 1));
    EXPECT_NEAR(values.tracks[std::size_t(*scene.camera.height)], 4, 1e-5);
    ASSERT_EQ(scene.lights.size(), 1);
    EXPECT_TRUE(scene.lights[0].is_point);
    EXPECT_NEAR(glm::length(vector(scene.lights[0].direction) - glm::dvec3(200, 0, 0)), 0, 1e-3);
    // sRGB's half is a fifth of the light.
    EXPECT_NEAR(vector(scene.surfaces[0].material.color).y, 0.214, 1e-3);
    EXPECT_EQ(vector(*scene.surfaces[0].material.inside), glm::dvec3(0, 0, 1));
}

TEST(Surfer, APerspectiveCameraStandsWhereItsMatrixSays) {
    const Scene scene = scene_of(with("ORTHOGRAPHIC", "PERSPECTIVE") + "camera_fov_y=50\n");
    const auto values = scene.surfaces[0].animation.at(scene.timeline.time(1));
    EXPECT_NEAR(values.tracks[std::size_t((*scene.camera.position)[0])], 2, 1e-4);
    EXPECT_EQ(values.tracks[std::size_t(scene.camera.fov)], 50);
}

TEST(Surfer, MistakesHaveTheLinesOfTheFile) {
    EXPECT_THAT(mistake_of(with("-1*a", "-1*q")),
                HasSubstr("ball.jsurf:16: surface.formula: unknown name 'q'"));
    EXPECT_EQ(mistake_of(with("light_color_0=1.0 1.0 1.0", "light_color_0=1.0 1.0")),
              "ball.jsurf:6: light_color_0: must be 3 numbers with spaces between");
    EXPECT_EQ(mistake_of(with("=0.30103", "=big")),
              "ball.jsurf:13: scale_factor: must be a number");
    EXPECT_EQ(
        mistake_of(with("=0.30103", "=99")),
        "ball.jsurf:13: scale_factor: must be from -30 to 30: the power of ten that the bounds "
        "are");
    EXPECT_EQ(mistake_of(with("=ORTHOGRAPHIC_CAMERA", "=FISHEYE")),
              "ball.jsurf:2: camera_type: must be ORTHOGRAPHIC_CAMERA or PERSPECTIVE_CAMERA, not "
              "FISHEYE");
    EXPECT_EQ(mistake_of("a=1\n"), "ball.jsurf:1: surface_equation: is missing; write "
                                   "surface_equation=x^2+y^2+z^2-1");
    EXPECT_EQ(mistake_of(with("surface_parameter_b=7", "surface_parameter_b c=7")),
              "ball.jsurf:4: surface_parameter_b c: a parameter's name is letters, digits and _");
    EXPECT_THAT(mistake_of(with("surface_parameter_a=0.25", "surface_parameter_c=1")),
                HasSubstr("unknown name 'a'"));
}

// Whatever is in an equation, it stays in its text.
TEST(Surfer, TextsAreNoTomlOfTheirOwn) {
    for (const char* equation : {"x\"\\ncamera.fov=3", "x'", "]]", "x\x01y"}) {
        EXPECT_THAT(mistake_of("surface_equation=" + std::string(equation) + "\n"),
                    testing::StartsWith("ball.jsurf:1: "))
            << equation;
    }
}

TEST(Surfer, IsWrittenAsASceneFile) {
    EXPECT_THAT(surfer_as_toml(surfer_ball, "ball.jsurf"),
                HasSubstr("surface.formula = \"x^2+y^2+z^2-1*a\""));
}

} // namespace
} // namespace isomotion::scene
