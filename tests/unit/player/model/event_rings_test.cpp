// Rings are where the camera shows the places, and nowhere else.
#include "player/model/event_rings.h"

#include <gmock/gmock.h>

#include "scene/rays.h"
#include "unit/formula/testing.h"

namespace isomotion::player {
namespace {

using formula::Random;
using scene::CameraAt;
using Projection = scene::Camera::Projection;

// Looks from (0, 0, 3) at the origin; the picture is 6 units high there.
CameraAt right_angle() {
    CameraAt camera;
    camera.fov = 90;
    return camera;
}

void expect_at(const std::optional<glm::dvec2>& found, glm::dvec2 wanted) {
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, wanted.x, 1e-12);
    EXPECT_NEAR(found->y, wanted.y, 1e-12);
}

TEST(EventRings, AreProjectedAsAPinholeDoes) {
    CameraAt camera = right_angle();
    expect_at(projected(camera, {0, 0, 0}), {0, 0});
    expect_at(projected(camera, {1.5, -0.75, 0}), {1.5 / 6, -0.75 / 6});
    expect_at(projected(camera, {1.5, -0.75, 2}), {1.5 / 2, -0.75 / 2}); // 1 before the eye
    expect_at(projected(camera, {1.5, -0.75, -6}), {1.5 / 18, -0.75 / 18});
    camera.zoom = 2;
    expect_at(projected(camera, {1.5, -0.75, 0}), {1.5 / 3, -0.75 / 3});
    camera.projection = Projection::orthographic;
    camera.height = 8;
    for (const double z : {0.0, 2.9, -50.0})
        expect_at(projected(camera, {1, -3, z}), {1 / 4.0, -3 / 4.0});
}

TEST(EventRings, WhatIsBehindTheEyeIsNowhere) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        CameraAt camera = right_angle();
        camera.projection = projection;
        camera.height = 2;
        EXPECT_FALSE(projected(camera, {0, 0, 4}));
        EXPECT_FALSE(projected(camera, {0.3, 0.2, 3}));
        EXPECT_FALSE(projected(camera, camera.position));
        EXPECT_FALSE(projected(camera, {NAN, 0, 0}));
        EXPECT_TRUE(projected(camera, {0, 0, 2.999}));
    }
}

// Any point of a pixel's ray is projected to that pixel.
TEST(EventRings, AreWhereTheRaysOfThePictureGo) {
    Random random(31);
    constexpr int width = 96, height = 64;
    for (int trial = 0; trial < 500; ++trial) {
        scene::SceneAt now;
        now.surfaces.resize(1);
        const double size = std::exp(random.in(-8, 8));
        const auto vector = [&](double reach) {
            const auto p = random.point(reach);
            return glm::dvec3(p[0], p[1], p[2]);
        };
        now.camera.target = vector(20 * size);
        now.camera.position = now.camera.target + vector(size) + glm::dvec3(0, 0.01 * size, 0);
        now.camera.up = vector(3);
        now.camera.fov = random.in(5, 120);
        now.camera.zoom = std::exp(random.in(-1, 1));
        now.camera.height = size * random.in(0.5, 2);
        now.camera.projection =
            random.below(2) == 0 ? Projection::perspective : Projection::orthographic;
        now.surfaces[0].bounds.centre = now.camera.target;
        now.surfaces[0].bounds.radius = 0.01 * size;
        const scene::Rays rays = scene::rays(now, width, height);
        const double u = random.in(-1, 1), v = random.in(-1, 1), along = random.in(0.1, 9);
        const glm::dvec3 across = u * rays.right + v * rays.up;
        const glm::dvec3 point = rays.parallel
                                     ? rays.origin - rays.axis + across + along * rays.axis
                                     : rays.origin - rays.axis + along * (rays.axis + across);
        const auto at = projected(now.camera, point);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->x, u / 2 * width / height, 1e-9);
        EXPECT_NEAR(at->y, v / 2, 1e-9);
    }
}

PlacedEvent at_frame(double frame, glm::dvec3 where, int surface = 0) {
    return {frame, frame, topology::Kind::merge, true, true, where, surface};
}

TEST(EventRings, AreInThePictureAroundTheirFrames) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.camera = right_angle();
    const std::vector<PlacedEvent> events{at_frame(10, {1, 0, 0}), at_frame(11.5, {0, 1, 0}),
                                          at_frame(12, {99, 0, 0}), at_frame(12, {0, 0, 7})};
    const auto seen = [&](double frame) {
        std::vector<std::size_t> found;
        for (const Ring& ring : rings(events, now, frame, 1)) found.push_back(ring.event);
        return found;
    };
    using testing::ElementsAre, testing::IsEmpty;
    EXPECT_THAT(seen(10 - ring_frames), IsEmpty());
    EXPECT_THAT(seen(9), ElementsAre(0, 1));
    EXPECT_THAT(seen(12), ElementsAre(1, 0)) << "the nearest first, not what is beside or behind";
    EXPECT_THAT(seen(15), ElementsAre(1));
    EXPECT_THAT(seen(11.5 + ring_frames), IsEmpty());
    EXPECT_DOUBLE_EQ(rings(events, now, 10, 1)[0].nearness, 1);
    EXPECT_DOUBLE_EQ(rings(events, now, 8, 1)[0].nearness, 1 - 2 / ring_frames);
}

TEST(EventRings, OfWhatLastsAreThereAllTheWhile) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.camera = right_angle();
    PlacedEvent place = at_frame(20, {});
    place.last = 60;
    for (const double frame : {20.0, 33.0, 60.0})
        EXPECT_DOUBLE_EQ(rings({place}, now, frame, 1).at(0).nearness, 1);
    EXPECT_TRUE(rings({place}, now, 60 + ring_frames, 1).empty());
}

TEST(EventRings, AWidePictureShowsMoreBesides) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.camera = right_angle();
    const std::vector<PlacedEvent> events{at_frame(1, {4, 0, 0})};
    EXPECT_TRUE(rings(events, now, 1, 1).empty());
    EXPECT_EQ(rings(events, now, 1, 1.5).size(), 1u);
}

// Places are formula coordinates of their surface; it may be anywhere, and turned.
TEST(EventRings, AreInTheWorldWhereTheirSurfaceIs) {
    scene::SceneAt now;
    now.camera = right_angle();
    now.surfaces.resize(2);
    now.surfaces[0].placement.translate = {0.5, 0, 0};
    scene::PlacementAt& second = now.surfaces[1].placement;
    second.translate = {-1, 1, 0};
    second.scale = 2;
    second.rotate = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1); // by a right angle: x becomes y
    const auto found =
        rings({at_frame(1, {1, 0, 0}), at_frame(1, {0.5, 0, 0}, 1), at_frame(1, {0, 0, 0}, 2)}, now,
              1, 1);
    ASSERT_EQ(found.size(), 2u) << "there is no third surface";
    expect_at(found[0].at, {1.5 / 6, 0});
    expect_at(found[1].at, {-1 / 6.0, 2 / 6.0});
}

TEST(EventRings, AreNoMoreThanAPictureHolds) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.camera = right_angle();
    std::vector<PlacedEvent> events(500, at_frame(3, {}));
    events.push_back(at_frame(2, {}));
    const auto found = rings(events, now, 2, 1);
    ASSERT_EQ(found.size(), most_rings);
    EXPECT_EQ(found[0].event, 500u);
}

} // namespace
} // namespace isomotion::player
