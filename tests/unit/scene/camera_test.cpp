// Where cameras stand, and what they take in.
#include <fmt/format.h>

#include "scene/rays.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

class Cameras : public Scenes {
protected:
    // The ball of radius 1 in bounds of 1.5, with this [camera].
    SceneAt seen(const std::string& camera, const std::string& bounds = "{ sphere = 1.5 }",
                 const std::string& size = "[64, 64]") const {
        return at_time(loaded("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = " + bounds +
                              "\n[camera]\n" + camera + "\n[output]\nsize = " + size + "\n"),
                       0);
    }
    CameraAt camera(const std::string& text) const { return seen(text).camera; }
    std::string mistake_in(const std::string& camera) const {
        return mistake("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
                       "[camera]\n" +
                       camera);
    }
};

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-12)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

// Where the picture shows a point in formula coordinates.
glm::dvec2 picture(const Rays& rays, const glm::dvec3& point) {
    const glm::dvec3 from = point - (rays.origin - rays.axis);
    const double depth =
        rays.parallel ? 1 : glm::dot(from, rays.axis) / glm::dot(rays.axis, rays.axis);
    const glm::dvec3 across = from / depth - rays.axis;
    return {glm::dot(across, rays.right) / glm::dot(rays.right, rays.right),
            glm::dot(across, rays.up) / glm::dot(rays.up, rays.up)};
}

TEST_F(Cameras, OrbitTheTargetAboutUp) {
    expect_near(camera("azimuth = 0\nelevation = 0\ndistance = 4").position, {4, 0, 0});
    expect_near(camera("azimuth = 90\nelevation = 0\ndistance = 4").position, {0, 4, 0});
    expect_near(camera("azimuth = -90\nelevation = 0\ndistance = 4").position, {0, -4, 0});
    expect_near(camera("azimuth = 450\nelevation = 30\ndistance = 4").position,
                {0, 2 * std::sqrt(3.0), 2});
    expect_near(camera("elevation = 90\ndistance = 4").position, {0, 0, 4});
    expect_near(camera("elevation = -90\ndistance = 4").position, {0, 0, -4});
    expect_near(camera("azimuth = 0\nelevation = 0\ndistance = 4\ntarget = [1, 2, 3]").position,
                {5, 2, 3});
    // Any `up` is a pole: the orbit turns about it, and begins over the x axis.
    expect_near(camera("azimuth = 0\nelevation = 0\ndistance = 4\nup = [0, 2, 0]").position,
                {4, 0, 0});
    expect_near(camera("azimuth = 90\nelevation = 0\ndistance = 4\nup = [0, 2, 0]").position,
                {0, 0, -4});
    expect_near(camera("elevation = 90\ndistance = 4\nup = [1, 1, 0]").position,
                {2 * std::sqrt(2.0), 2 * std::sqrt(2.0), 0});
    expect_near(camera("azimuth = 0\nelevation = 0\ndistance = 4\nup = [3, 0, 0]").position,
                {0, 4, 0});
}

TEST_F(Cameras, OrbitTheMiddleOfTheBoundsInTheWorld) {
    const SceneAt now = at_time(loaded("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\n"
                                       "bounds = { box = [[0, 0, 0], [2, 4, 6]] }\n"
                                       "transform = { translate = [10, 0, 0], scale = 3 }\n"
                                       "[camera]\nazimuth = 0\nelevation = 0\ndistance = 100\n"),
                                0);
    expect_near(now.camera.target, {13, 6, 9});
    expect_near(now.camera.position, {113, 6, 9});
}

TEST_F(Cameras, BoundsBesideTheTargetStayInThePicture) {
    for (const char* projection : {"perspective", "orthographic"}) {
        const SceneAt now =
            seen(fmt::format("target = [2, -1, 0.5]\nprojection = \"{}\"", projection));
        const Rays r = rays(now, 64, 64);
        for (int k = 0; k < 1000; ++k) {
            const glm::dvec3 direction(std::sin(1.7 * k), std::sin(2.9 * k), std::sin(4.3 * k + 1));
            const glm::dvec2 at = picture(r, 1.5 * glm::normalize(direction));
            EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1 + 1e-12) << projection;
        }
    }
}

TEST_F(Cameras, OrthographicBoundsTouchTheNearerEdges) {
    for (const auto& [size, width, height] :
         {std::tuple{"[64, 64]", 64, 64}, {"[128, 64]", 128, 64}, {"[64, 128]", 64, 128}}) {
        const SceneAt now = seen("projection = \"orthographic\"", "{ sphere = 1.5 }", size);
        const Rays r = rays(now, width, height);
        const glm::dvec3 edge = width < height ? r.right : r.up;
        EXPECT_NEAR(glm::length(edge), 1.5, 1e-12) << size;
        EXPECT_NEAR(glm::length(r.right) / glm::length(r.up), double(width) / height, 1e-12);
        // The plane where rays begin lies before the bounds.
        EXPECT_GE(glm::length(r.axis), 1.5) << size;
    }
}

// Depth does not matter; what is at the target is as large as in perspective.
TEST_F(Cameras, OrthographicRaysAreParallel) {
    const std::string stand = "position = [3, 2, 1.5]\ntarget = [0.1, 0.2, 0.3]\nfov = 35\n";
    const Rays flat = rays(seen(stand + "projection = \"orthographic\""), 64, 48);
    const Rays deep = rays(seen(stand), 64, 48);
    EXPECT_TRUE(flat.parallel);
    EXPECT_FALSE(deep.parallel);
    const glm::dvec3 forward = glm::normalize(flat.axis);
    expect_near(forward, glm::normalize(deep.axis));
    const glm::dvec3 target(0.1, 0.2, 0.3);
    for (int k = 0; k < 50; ++k) {
        glm::dvec3 point(std::sin(1.7 * k), std::sin(2.9 * k), std::sin(4.3 * k + 1));
        point -= glm::dot(point - target, forward) * forward; // in the plane through the target
        const glm::dvec2 at = picture(flat, point), same = picture(deep, point);
        EXPECT_LT(glm::length(at - same), 1e-12);
        EXPECT_LT(glm::length(picture(flat, point + std::sin(5.0 * k) * forward) - at), 1e-12);
    }
}

TEST_F(Cameras, HeightIsWhatAnOrthographicPictureTakesIn) {
    const Rays r = rays(seen("projection = \"orthographic\"\nheight = 7\nzoom = 2"), 64, 64);
    EXPECT_NEAR(glm::length(r.up), 1.75, 1e-12);
}

TEST_F(Cameras, ZoomMagnifiesAboutTheMiddle) {
    for (const char* projection : {"perspective", "orthographic"}) {
        const std::string stand = fmt::format("projection = \"{}\"\nzoom = ", projection);
        const SceneAt near = seen(stand + "3"), far = seen(stand + "1");
        EXPECT_EQ(near.camera.position, far.camera.position);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 point(std::sin(1.7 * k), std::sin(2.9 * k), std::sin(4.3 * k + 1));
            const glm::dvec2 large = picture(rays(near, 64, 64), point);
            EXPECT_LT(glm::length(large - 3.0 * picture(rays(far, 64, 64), point)), 1e-12);
        }
    }
}

TEST_F(Cameras, EveryNumberMoves) {
    const Scene scene = loaded("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\n"
                               "bounds = { sphere = 1.5 }\n[camera]\nazimuth = \"90*t\"\n"
                               "elevation = \"30*t\"\ndistance = \"4 + t\"\nzoom = \"1 + t\"\n"
                               "fov = \"90\"\n");
    const CameraAt now = at_time(scene, 1).camera;
    expect_near(now.position, {0, 5 * std::cos(M_PI / 6), 2.5});
    EXPECT_EQ(now.fov, 90);
    EXPECT_EQ(now.zoom, 2);
}

TEST_F(Cameras, CanBeSetOnTheCommandLine) {
    const Scene scene =
        loaded(ball(), {"camera.fov=30", "camera.projection=orthographic", "camera.height=5"});
    EXPECT_EQ(scene.camera.projection, Camera::Projection::orthographic);
    EXPECT_EQ(at_time(scene, 0).camera.fov, 30);
    EXPECT_EQ(at_time(scene, 0).camera.height, 5);
}

TEST_F(Cameras, AreFocusedOnTheirTargetUnlessToldOtherwise) {
    EXPECT_EQ(camera("").aperture, 0);
    EXPECT_NEAR(camera("distance = 4\naperture = 0.5").focus, 4, 1e-12);
    EXPECT_EQ(camera("distance = 4\naperture = 0.5").aperture, 0.5);
    EXPECT_EQ(camera("distance = 4\naperture = 0.5\nfocus = 3").focus, 3);
    const Scene pulled = loaded(ball(), {"camera.aperture=t", "camera.focus=1+t"});
    EXPECT_EQ(at_time(pulled, 2).camera.aperture, 2);
    EXPECT_EQ(at_time(pulled, 2).camera.focus, 3);
}

// One picture shows neither blur, and a scene that wants none is one picture.
TEST_F(Cameras, ThatBlurTakeSixteenSamples) {
    EXPECT_EQ(loaded(ball()).output.samples, 1);
    EXPECT_EQ(loaded(ball(), {"camera.shutter=0"}).output.samples, 1);
    EXPECT_EQ(loaded(ball(), {"camera.shutter=0.5"}).output.samples, 16);
    EXPECT_EQ(loaded(ball(), {"camera.aperture=0.1"}).output.samples, 16);
    EXPECT_EQ(loaded(ball(), {"camera.aperture=0.1", "output.samples=4"}).output.samples, 4);
    EXPECT_EQ(mistake(ball(), {"output.samples=0"}),
              "--set: output.samples: must be from 1 to 1024, not 0");
    EXPECT_EQ(mistake(ball_and("samples = 1025")),
              "scene.toml:15: output.samples: must be from 1 to 1024, not 1025");
}

TEST_F(Cameras, MistakesNameTheKey) {
    EXPECT_EQ(mistake_in("projection = \"fisheye\""),
              "scene.toml:5: camera.projection: there is no projection 'fisheye'; known: "
              "perspective, orthographic");
    EXPECT_EQ(mistake_in("position = [1, 2, 3]\nazimuth = 3"),
              "scene.toml:6: camera.azimuth: is of a camera on an orbit; this one has a position. "
              "Give one or the other");
    EXPECT_EQ(mistake_in("height = 3"),
              "scene.toml:5: camera.height: is of an orthographic camera: projection = "
              "\"orthographic\"; this one has fov");
    EXPECT_EQ(mistake_in("azimut = 3"),
              "scene.toml:5: camera.azimut: unknown key; did you mean 'azimuth'?");
    EXPECT_EQ(mistake_in("zoom = 0"), "scene.toml:5: camera.zoom at t = 0: must be above 0, not 0");
    EXPECT_EQ(mistake_in("distance = \"-1\""),
              "scene.toml:5: camera.distance at t = 0: must be above 0, not -1");
    EXPECT_EQ(mistake_in("projection = \"orthographic\"\nheight = 0"),
              "scene.toml:6: camera.height at t = 0: must be above 0, not 0");
    EXPECT_EQ(mistake_in("shutter = 1.5"),
              "scene.toml:5: camera.shutter: must be from 0 to 1, not 1.5");
    EXPECT_EQ(mistake_in("shutter = -0.1"),
              "scene.toml:5: camera.shutter: must be from 0 to 1, not -0.1");
    EXPECT_EQ(mistake_in("aperture = -0.1"),
              "scene.toml:5: camera.aperture at t = 0: must be 0 or above, not -0.1");
    EXPECT_EQ(mistake_in("aperture = 0.1\nfocus = 0"),
              "scene.toml:6: camera.focus at t = 0: must be above 0, not 0");
    EXPECT_EQ(mistake_in("focus = 3"),
              "scene.toml:5: camera.focus: is of a camera with a lens: give its diameter, "
              "aperture, too");
    EXPECT_EQ(mistake_in("up = [0, 0, 0]"),
              "scene.toml:5: camera.up.x at t = 0: `up` has no direction");
}

} // namespace
} // namespace isomotion::scene
