// A scene without a camera is seen whole, and as large as it can be.
#include <cmath>

#include <fmt/format.h>

#include "scene/rays.h"
#include "testing.h"
#include "unit/formula/testing.h"

namespace isomotion::scene::framing_test {
namespace {

using formula::Random;

class Framing : public Scenes {
protected:
    SceneAt framed(const std::string& bounds, const std::string& placement, double fov, int width,
                   int height) const {
        return at_time(loaded(fmt::format("[surface]\n"
                                          "formula = \"x^2 + y^2 + z^2 - 1\"\n"
                                          "bounds = {}\n"
                                          "transform = {}\n"
                                          "[camera]\n"
                                          "fov = {}\n"
                                          "[output]\n"
                                          "size = [{}, {}]\n",
                                          bounds, placement, fov, width, height)),
                       0);
    }
};

std::string any_bounds(Random& random) {
    const auto p = random.point(5);
    const double size = std::exp(random.in(-4, 4));
    if (random.below(2) == 0) {
        return fmt::format("{{ sphere = {}, centre = [{}, {}, {}] }}", size, p[0], p[1], p[2]);
    }
    return fmt::format("{{ box = [[{}, {}, {}], [{}, {}, {}]] }}", p[0], p[1], p[2], p[0] + size,
                       p[1] + 2 * size, p[2] + 0.5 * size);
}

std::string any_placement(Random& random) {
    const auto t = random.point(100), r = random.point(180);
    return fmt::format("{{ translate = [{}, {}, {}], rotate = [{}, {}, {}], scale = {} }}", t[0],
                       t[1], t[2], r[0], r[1], r[2], std::exp(random.in(-3, 3)));
}

// Picture coordinates of a point in formula coordinates: where its ray crosses the plane.
glm::dvec2 picture(const Rays& rays, const glm::dvec3& point) {
    const glm::dvec3 from_eye = point - (rays.origin - rays.axis);
    const double depth = glm::dot(from_eye, rays.axis) / glm::dot(rays.axis, rays.axis);
    const glm::dvec3 across = from_eye / depth - rays.axis;
    return {glm::dot(across, rays.right) / glm::dot(rays.right, rays.right),
            glm::dot(across, rays.up) / glm::dot(rays.up, rays.up)};
}

TEST_F(Framing, TheBoundingSphereIsInThePictureAndTouchesItsEdge) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const int width = 16 + random.below(1000), height = 16 + random.below(1000);
        const double fov = random.in(2, 150);
        const SceneAt now = framed(any_bounds(random), any_placement(random), fov, width, height);
        const Rays seen = rays(now, width, height);
        const auto on_sphere = [&](const glm::dvec3& direction) {
            return picture(seen, now.surfaces[0].bounds.centre +
                                     now.surfaces[0].bounds.radius * direction);
        };
        for (int k = 0; k < 200; ++k) {
            const auto p = random.point(1);
            const glm::dvec2 at = on_sphere(glm::normalize(glm::dvec3(p[0], p[1], p[2])));
            EXPECT_LE(std::abs(at.x), 1 + 1e-9);
            EXPECT_LE(std::abs(at.y), 1 + 1e-9);
        }
        // The ray of the nearer edge touches the sphere where the radius stands on it.
        const glm::dvec3 edge = width < height ? seen.right : seen.up;
        const glm::dvec3 forward = glm::normalize(seen.axis), across = glm::normalize(edge);
        const double half = std::atan(glm::length(edge) / glm::length(seen.axis));
        const glm::dvec2 touch = on_sphere(across * std::cos(half) - forward * std::sin(half));
        EXPECT_NEAR(width < height ? touch.x : touch.y, 1, 1e-9);
    }
}

TEST_F(Framing, TheMiddleOfTheBoundsIsTheMiddleOfThePicture) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const SceneAt now = framed(any_bounds(random), any_placement(random), 40, 64, 48);
        EXPECT_LT(glm::length(picture(rays(now, 64, 48), now.surfaces[0].bounds.centre)), 1e-9);
    }
}

TEST_F(Framing, TheCameraFollowsMovingBounds) {
    const Scene scene = loaded("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\n"
                               "bounds = { sphere = \"1 + t\" }\n"
                               "transform = { translate = [\"5*t\", 0, 0] }\n");
    const CameraAt before = at_time(scene, 0).camera, after = at_time(scene, 1).camera;
    EXPECT_EQ(after.target, glm::dvec3(5, 0, 0));
    EXPECT_NEAR(glm::length(after.position - after.target),
                2 * glm::length(before.position - before.target), 1e-12);
}

} // namespace
} // namespace isomotion::scene::framing_test
