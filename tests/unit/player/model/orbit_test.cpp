// Cameras in the hand, against the rays that the renderer gives them.
#include "player/model/orbit.h"

#include <fmt/format.h>

#include "scene/rays.h"
#include "unit/formula/testing.h"

namespace isomotion::player {
namespace {

using formula::Random;
using scene::CameraAt;
using Projection = scene::Camera::Projection;

constexpr int width = 96, height = 64;

glm::dvec3 random_vector(Random& random, double reach) {
    const auto p = random.point(reach);
    return {p[0], p[1], p[2]};
}

// A camera of any size, anywhere within a hundred times its size.
CameraAt random_camera(Random& random) {
    const double size = std::exp(random.in(-10, 10));
    CameraAt camera;
    camera.target = random_vector(random, 100 * size);
    camera.position = camera.target + random_vector(random, size);
    camera.up = random_vector(random, 3);
    camera.fov = random.in(5, 120);
    camera.zoom = std::exp(random.in(-1, 1));
    camera.projection = random.below(2) == 0 ? Projection::perspective : Projection::orthographic;
    camera.height = size * random.in(0.5, 2);
    camera.focus = random.below(2) == 0 ? glm::length(camera.position - camera.target) : size * 0.7;
    return camera;
}

double distance(const CameraAt& c) { return glm::length(c.position - c.target); }
double elevation(const CameraAt& c) {
    return glm::degrees(
        std::asin(glm::dot(glm::normalize(c.position - c.target), glm::normalize(c.up))));
}

scene::Rays rays_of(const CameraAt& camera) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.camera = camera;
    now.surfaces[0].bounds.centre = camera.target; // the plane of anchors goes through the target
    now.surfaces[0].bounds.radius = 0.01 * distance(camera);
    return scene::rays(now, width, height);
}

// Where the picture shows a point, in heights from its middle.
glm::dvec2 seen(const CameraAt& camera, const glm::dvec3& point) {
    const scene::Rays r = rays_of(camera);
    const glm::dvec3 from = point - (r.origin - r.axis);
    const double depth = r.parallel ? 1 : glm::dot(from, r.axis) / glm::dot(r.axis, r.axis);
    const glm::dvec3 across = from / depth - r.axis;
    const double u = glm::dot(across, r.right) / glm::dot(r.right, r.right);
    const double v = glm::dot(across, r.up) / glm::dot(r.up, r.up);
    return {0.5 * u * width / height, 0.5 * v};
}

void expect_rest_unchanged(const CameraAt& before, const CameraAt& after) {
    EXPECT_EQ(before.up, after.up);
    EXPECT_EQ(before.fov, after.fov);
    EXPECT_EQ(before.zoom, after.zoom);
    EXPECT_EQ(before.aperture, after.aperture);
    EXPECT_EQ(before.projection, after.projection);
    const double sharp = distance(before);
    if (before.focus == sharp) {
        EXPECT_NEAR(after.focus, distance(after), 1e-9 * distance(after));
    } else {
        EXPECT_EQ(after.focus, before.focus);
    }
}

// Every motion is tested on these: cameras and drags of all kinds.
template<class Check> void for_many(Check&& check) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const CameraAt camera = random_camera(random);
        check(random, camera);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(Orbit, PointsAreSeenWhereTheHandTakesThem) {
    for_many([](Random& random, const CameraAt& camera) {
        const glm::dvec2 at(random.in(-0.7, 0.7), random.in(-0.5, 0.5));
        const glm::dvec2 there = seen(camera, point_at(camera, at));
        EXPECT_NEAR(there.x, at.x, 1e-10);
        EXPECT_NEAR(there.y, at.y, 1e-10);
        const PictureAxes axes = picture_axes(camera);
        const scene::Rays r = rays_of(camera);
        EXPECT_LT(glm::length(axes.right - glm::normalize(r.right)), 1e-12);
        EXPECT_LT(glm::length(axes.up - glm::normalize(r.up)), 1e-12);
        EXPECT_LT(glm::length(axes.forward - glm::normalize(r.axis)), 1e-12);
        EXPECT_NEAR(shown_height(camera), 2 * glm::length(r.up), 1e-9 * shown_height(camera));
    });
}

TEST(Orbit, KeepsTargetDistanceAndUp) {
    for_many([](Random& random, const CameraAt& camera) {
        const CameraAt moved = orbited(camera, {random.in(-3, 3), random.in(-3, 3)});
        EXPECT_EQ(moved.target, camera.target);
        EXPECT_EQ(moved.height, camera.height);
        EXPECT_NEAR(distance(moved), distance(camera), 1e-12 * glm::length(camera.target));
        EXPECT_LE(std::abs(elevation(moved)), 90 - pole_distance + 1e-6);
        expect_rest_unchanged(camera, moved);
    });
}

TEST(Orbit, TurnsByTheHandsWay) {
    CameraAt camera;
    camera.position = {4, 0, 0};
    camera.target = {0, 0, 0};
    camera.up = {0, 0, 2};
    const auto expect_at = [&](const glm::dvec2& drag, const glm::dvec3& position) {
        const CameraAt moved = orbited(camera, drag);
        EXPECT_LT(glm::length(moved.position - position), 1e-12) << drag.x << " " << drag.y;
    };
    // Dragged to the right, the camera goes to the left, which is -y seen from x.
    expect_at({0.5, 0}, {0, -4, 0});
    expect_at({-0.5, 0}, {0, 4, 0});
    expect_at({1, 0}, {-4, 0, 0});
    expect_at({2, 0}, {4, 0, 0});
    expect_at({0, -0.25}, {std::sqrt(8.0), 0, std::sqrt(8.0)});
    expect_at({0, 0.25}, {std::sqrt(8.0), 0, -std::sqrt(8.0)});
    expect_at({0.5, -0.25}, {0, -std::sqrt(8.0), std::sqrt(8.0)});
}

// The surface follows the hand: what is in front of the target goes the way of the cursor.
TEST(Orbit, TheNearSideFollowsTheCursor) {
    for_many([](Random& random, const CameraAt& camera) {
        if (std::abs(elevation(camera)) > 80) return;
        const glm::dvec3 near = camera.target + 0.3 * (camera.position - camera.target);
        const glm::dvec2 drag(random.in(0.001, 0.01), random.in(0.001, 0.01));
        const glm::dvec2 right = seen(orbited(camera, {drag.x, 0}), near);
        const glm::dvec2 up = seen(orbited(camera, {0, drag.y}), near);
        EXPECT_GT(right.x, 0);
        EXPECT_GT(up.y, 0);
        EXPECT_NEAR(up.x, 0, 1e-9);
    });
}

// Many small drags lead where a large one does, as long as no pole is in the way.
TEST(Orbit, SmallStepsAddUp) {
    for_many([](Random& random, CameraAt camera) {
        if (std::abs(elevation(camera)) > 40) return;
        const glm::dvec2 drag(random.in(-2, 2), random.in(-0.2, 0.2));
        const CameraAt once = orbited(camera, drag);
        for (int k = 0; k < 50; ++k) camera = orbited(camera, drag / 50.0);
        const double rounding = 1e-11 * glm::length(camera.target) + 1e-9 * distance(camera);
        EXPECT_LT(glm::length(once.position - camera.position), rounding);
    });
}

TEST(Orbit, StopsBeforeThePolesAndComesBack) {
    CameraAt camera;
    camera.position = {4, 1, 1};
    camera.up = {0, 0, 1};
    const CameraAt high = orbited(camera, {0, -5});
    EXPECT_NEAR(elevation(high), 90 - pole_distance, 1e-6);
    EXPECT_LT(glm::length(orbited(high, {0, -1}).position - high.position), 1e-12);
    EXPECT_NEAR(elevation(orbited(camera, {0, 5})), pole_distance - 90, 1e-6);
    // The side it went up on is not forgotten.
    const CameraAt back = orbited(high, {0, (90 - pole_distance) / degrees_per_height});
    EXPECT_NEAR(back.position.y / back.position.x, 0.25, 1e-9);
    EXPECT_GT(back.position.x, 0);
    // At the pole the picture turns about its middle.
    const CameraAt turned = orbited(high, {0.5, 0});
    EXPECT_NEAR(glm::dot(picture_axes(high).up, picture_axes(turned).right), -1, 1e-5);
}

// A scene's camera may stand exactly above its target.
TEST(Orbit, LeavesAPoleWithoutAJump) {
    for (const glm::dvec3& pole :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 2, 0), glm::dvec3(-1, 0, 0), glm::dvec3(1, 1, 1)}) {
        for (const double side : {5.0, -5.0}) {
            CameraAt camera;
            camera.up = pole;
            camera.target = {1, 2, 3};
            camera.position = camera.target + side * glm::normalize(pole);
            const CameraAt moved = orbited(camera, {0, side > 0 ? 1e-4 : -1e-4});
            const PictureAxes before = picture_axes(camera), after = picture_axes(moved);
            EXPECT_LT(glm::length(before.right - after.right), 0.01);
            EXPECT_LT(glm::length(before.up - after.up), 0.01);
            EXPECT_NEAR(std::abs(elevation(moved)), 90 - pole_distance, 1e-6);
        }
    }
}

TEST(Pan, WhatIsDraggedStaysUnderTheCursor) {
    for_many([](Random& random, const CameraAt& camera) {
        const glm::dvec2 from(random.in(-0.7, 0.7), random.in(-0.5, 0.5));
        const glm::dvec2 drag(random.in(-2, 2), random.in(-2, 2));
        const CameraAt moved = panned(camera, drag);
        const glm::dvec2 there = seen(moved, point_at(camera, from));
        EXPECT_NEAR(there.x, from.x + drag.x, 1e-9);
        EXPECT_NEAR(there.y, from.y + drag.y, 1e-9);
        EXPECT_EQ(moved.height, camera.height);
        expect_rest_unchanged(camera, moved);
    });
}

TEST(Dolly, WhatIsUnderTheCursorStaysThere) {
    for_many([](Random& random, const CameraAt& camera) {
        const glm::dvec2 at(random.in(-0.7, 0.7), random.in(-0.5, 0.5));
        const double amount = random.in(-2, 2);
        const CameraAt moved = dollied(camera, amount, at);
        const glm::dvec2 there = seen(moved, point_at(camera, at));
        EXPECT_NEAR(there.x, at.x, 1e-9);
        EXPECT_NEAR(there.y, at.y, 1e-9);
        // Anything else in that plane is magnified about it.
        const glm::dvec2 beside = seen(moved, point_at(camera, {at.x + 0.1, at.y}));
        EXPECT_NEAR(beside.x, at.x + 0.1 * std::exp(amount), 1e-9);
        EXPECT_NEAR(shown_height(moved), std::exp(-amount) * shown_height(camera),
                    1e-9 * shown_height(camera));
        if (camera.projection == Projection::orthographic) {
            EXPECT_NEAR(distance(moved), distance(camera), 1e-12 * glm::length(camera.target));
        }
        expect_rest_unchanged(camera, moved);
    });
}

TEST(Dolly, IsUndoneByItsOpposite) {
    for_many([](Random& random, const CameraAt& camera) {
        const glm::dvec2 at(random.in(-0.7, 0.7), random.in(-0.5, 0.5));
        const double amount = random.in(-2, 2);
        const CameraAt back = dollied(dollied(camera, amount, at), -amount, at);
        EXPECT_LT(glm::length(back.position - camera.position),
                  1e-11 * glm::length(camera.target) + 1e-11 * distance(camera));
        EXPECT_NEAR(back.height, camera.height, 1e-12 * camera.height);
    });
}

TEST(Dolly, NeverReachesTheTargetNorTheEndOfNumbers) {
    for (const double amount :
         {0.5, -0.5, 50.0, -50.0, 1e6, -1e6, double(INFINITY), -double(INFINITY), double(NAN)}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            SCOPED_TRACE(fmt::format("{} {}", amount, int(projection)));
            CameraAt camera;
            camera.position = {4, 0, 0};
            camera.target = {1, 1, 1};
            camera.height = 3;
            camera.projection = projection;
            const glm::dvec3 forward = picture_axes(camera).forward;
            for (int k = 0; k < 500; ++k) camera = dollied(camera, amount);
            EXPECT_LT(glm::length(picture_axes(camera).forward - forward), 1e-6);
            EXPECT_TRUE(distance(camera) > 0 && distance(camera) < 1e39);
            EXPECT_TRUE(camera.height > 0 && camera.height < 1e39);
            // It can be left again.
            const double shown = shown_height(camera);
            const CameraAt away = dollied(camera, amount > 0 ? -1 : 1);
            if (std::isfinite(amount)) {
                EXPECT_NE(shown_height(away), shown);
            }
        }
    }
}

TEST(Fit, ASphereAboutTheBoundsTouchesTheNearerEdges) {
    for_many([](Random& random, const CameraAt& camera) {
        scene::BoundsAt bounds;
        bounds.centre = random_vector(random, 2);
        bounds.radius = random.in(0.5, 3);
        scene::PlacementAt placement;
        placement.translate = random_vector(random, 10);
        placement.scale = std::exp(random.in(-5, 5));
        const double aspect = random.in(0.3, 3);
        const CameraAt moved = fitted(camera, bounds, placement, aspect);
        const glm::dvec3 middle = placement.to_world(bounds.centre);
        EXPECT_EQ(moved.target, middle);
        EXPECT_LT(glm::length(picture_axes(moved).forward - picture_axes(camera).forward), 1e-9);
        // The point of the sphere that is seen farthest out lies on a ray that touches the sphere.
        const double radius = bounds.radius * placement.scale, away = distance(moved);
        const double half = moved.projection == Projection::orthographic
                                ? radius / shown_height(moved)
                                : away * std::tan(std::asin(radius / away)) / shown_height(moved);
        EXPECT_NEAR(half, 0.5 * std::min(aspect, 1.0), 1e-9);
        EXPECT_GE(away, radius) << "rays begin before the bounds";
        expect_rest_unchanged(camera, moved);
    });
}

} // namespace
} // namespace isomotion::player
