// Random cameras: the tubes hold every ray and point that a driver may make of a pixel.
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "drawn_ray.h"
#include "roots/tube.h"

namespace isomotion::roots {
namespace {

constexpr unsigned seed = 20261121;

// Bounds and a camera of any size and place, that sees a part of the bounds.
struct Case {
    scene::SceneAt now;
    int width, height;
};

constexpr std::array<const char*, 5> kinds{"perspective", "orthographic", "far away", "inside",
                                           "along an axis, at the silhouette"};

Case random_case(Random& random, int kind) {
    Case c;
    c.now.surfaces.resize(1);
    scene::BoundsAt& bounds = c.now.surfaces[0].bounds;
    const double size = random.size(1e-4, 1e4);
    bounds.centre =
        random.below(2) ? glm::dvec3(0) : random.size(0.1, 10) * size * random.direction();
    if (random.below(2)) {
        bounds.shape = scene::Bounds::Shape::box;
        const glm::dvec3 half =
            size * glm::dvec3(random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1));
        bounds.min = bounds.centre - half;
        bounds.max = bounds.centre + half;
        bounds.radius = glm::length(half);
    } else {
        bounds.radius = size;
        bounds.min = bounds.centre - size;
        bounds.max = bounds.centre + size;
    }
    scene::PlacementAt& place = c.now.surfaces[0].placement;
    place.scale = random.size(1e-2, 1e2);
    place.translate = random.in(0, 10) * random.direction();

    const double radius = bounds.radius;
    glm::dvec3 away = random.direction(), up = random.direction();
    glm::dvec3 aside = random.in(0, 0.7) * radius * random.direction();
    double distance = random.in(1.2, 8) * radius;
    scene::CameraAt& camera = c.now.camera;
    camera.fov = random.in(5, 100);
    camera.height = random.size(0.01, 4) * radius * place.scale;
    camera.zoom = random.below(2) ? 1 : random.size(0.1, 1e4);
    const std::string_view is = kinds[std::size_t(kind)];
    if (is == "orthographic" || (is != "perspective" && random.below(3) == 0)) {
        camera.projection = scene::Camera::Projection::orthographic;
    }
    if (is == "far away") {
        distance = random.size(1e2, 1e6) * radius;
        camera.fov = std::max(1e-4, 3 * glm::degrees(radius / distance));
    } else if (is == "inside") {
        distance = random.in(0.01, 0.9) * radius;
    } else if (is == "along an axis, at the silhouette") {
        away = up = aside = glm::dvec3(0);
        const int axis = random.below(3);
        away[axis] = random.below(2) ? 1 : -1;
        up[(axis + 1) % 3] = 1;
        const int side = (axis + 1 + random.below(2)) % 3;
        aside[side] = bounds.max[side] - bounds.centre[side];
        aside[side] *= 1 + (random.below(2) ? 0 : random.in(-1, 1) * random.size(1e-8, 1e-2));
    }
    const glm::dvec3 target = bounds.centre + aside;
    camera.target = place.to_world(target);
    camera.position = place.to_world(target + distance * away);
    camera.up = up;
    constexpr std::array sizes{1, 7, 64, 513, 1920, 8192};
    c.width = sizes[std::size_t(random.below(6))];
    c.height = sizes[std::size_t(random.below(6))];
    return c;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

class DrawnTube : public testing::TestWithParam<int> {};

struct Drawn {
    const Tube& tube;
    const DrawnRay& ray;
    const Driver& driver;
};

template<class Check> void for_drawn_rays(int kind, const Check& check) {
    Random random(seed + unsigned(kind));
    for (int k = 0; k < 400; ++k) {
        const Case c = random_case(random, kind);
        SCOPED_TRACE(fmt::format("seed {}, camera {}: {}", seed + unsigned(kind), k,
                                 kinds[std::size_t(kind)]));
        const Uniforms uniforms(c.now, c.width, c.height);
        const Tubes tubes(c.now, c.width, c.height);
        for (int pixel = 0; pixel < 24; ++pixel) {
            const int column = random.below(c.width), row = random.below(c.height);
            const Tube tube = tubes.at(column, row);
            for (int d = 0; d < 6; ++d) {
                const Driver driver(random);
                const DrawnRay ray = drawn(uniforms, driver, column, c.height - 1 - row);
                check(Drawn{tube, ray, driver}, random);
                if (testing::Test::HasFailure()) return; // one is enough to read
            }
        }
    }
}

TEST_P(DrawnTube, HoldsEveryPointThatIsDrawn) {
    int points = 0;
    double most = 0; // of the radius that was needed
    for_drawn_rays(GetParam(), [&](const Drawn& is, Random& random) {
        const double off = largest(glm::dvec3(is.ray.direction) - is.tube.direction);
        EXPECT_LE(off, is.tube.direction_radius);
        if (is.ray.empty()) return;
        for (const double part : {0.0, 1.0, random.in(0, 1), random.in(0, 1)}) {
            const float t = float(is.ray.near + part * (double(is.ray.far) - is.ray.near));
            const glm::dvec3 point = is.ray.point(is.driver, t);
            const double miss = largest(point - (is.tube.anchor + double(t) * is.tube.direction));
            EXPECT_LE(miss, is.tube.radius) << "t = " << t;
            most = std::max(most, miss / is.tube.radius);
            ++points;
        }
    });
    EXPECT_GT(points, 5000);
    EXPECT_GT(most, 0.02) << "the tubes are so thick that nothing can be certain";
    RecordProperty("most_of_radius", fmt::format("{:.3f}", most));
}

TEST_P(DrawnTube, EndsWhereTheDrawnIntervalMayEnd) {
    int ends = 0, empty = 0;
    for_drawn_rays(GetParam(), [&](const Drawn& is, Random&) {
        const Tube& tube = is.tube;
        SCOPED_TRACE(fmt::format("drawn [{:.9g}, {:.9g}], tube {:.9g} {:.9g} {:.9g} {:.9g}, "
                                 "radius {:.3g}",
                                 is.ray.near, is.ray.far, tube.near, tube.near_inside,
                                 tube.far_inside, tube.far, tube.radius));
        if (is.ray.empty()) {
            // Nothing is certainly inside.
            EXPECT_FALSE(tube.near_inside <= tube.far_inside);
            ++empty;
            return;
        }
        EXPECT_LE(tube.near, is.ray.near);
        EXPECT_GE(tube.far, is.ray.far);
        ++ends;
        if (!(tube.near_inside <= tube.far_inside)) return;
        EXPECT_GE(tube.near_inside, is.ray.near);
        EXPECT_LE(tube.far_inside, is.ray.far);
    });
    EXPECT_GT(ends, 1000);
    EXPECT_GT(empty, 0);
}

TEST_P(DrawnTube, IsOrderedAndLiesOnItsRay) {
    Random random(seed + 100 + unsigned(GetParam()));
    for (int k = 0; k < 400; ++k) {
        SCOPED_TRACE(fmt::format("seed {}, camera {}", seed + 100 + unsigned(GetParam()), k));
        const Case c = random_case(random, GetParam());
        const Tubes tubes(c.now, c.width, c.height);
        EXPECT_EQ(tubes.width(), c.width);
        EXPECT_EQ(tubes.height(), c.height);
        const int column = random.below(c.width), row = random.below(c.height);
        const Tube tube = tubes.at(column, row);
        EXPECT_NEAR(glm::length(tube.direction), 1, 1e-14);
        EXPECT_GT(tube.radius, 0);
        // A pixel's width between it and the next row's.
        const Tube below = tubes.at(column, row + 1);
        EXPECT_NEAR(glm::distance(tube.anchor, below.anchor), tube.footprint,
                    1e-9 * tube.footprint + 1e-14 * glm::length(tube.anchor));
        // A ray of perspective comes from the eye, rounded as its axis is.
        if (c.now.camera.projection == scene::Camera::Projection::perspective) {
            const glm::dvec3 eye = c.now.surfaces[0].placement.to_local(c.now.camera.position);
            const glm::dvec3 to_eye = eye - tube.anchor;
            const glm::dvec3 off = to_eye - glm::dot(to_eye, tube.direction) * tube.direction;
            EXPECT_LE(glm::length(off), 4 * 0x1p-24 * (glm::length(eye) + glm::length(to_eye)));
        }
        if (!(tube.near <= tube.far)) continue;
        if (!(tube.near_inside <= tube.far_inside)) continue;
        EXPECT_LT(tube.near, tube.near_inside);
        EXPECT_LT(tube.far_inside, tube.far);
        // What is certainly inside is inside, and what is certainly outside is not.
        const auto outside = [&](double t) {
            const glm::dvec3 p = tube.anchor + t * tube.direction - c.now.surfaces[0].bounds.centre;
            if (c.now.surfaces[0].bounds.shape == scene::Bounds::Shape::sphere) {
                return glm::length(p) - c.now.surfaces[0].bounds.radius;
            }
            const glm::dvec3 past =
                glm::abs(p) - (c.now.surfaces[0].bounds.max - c.now.surfaces[0].bounds.centre);
            return std::max({past.x, past.y, past.z});
        };
        for (const double t : {tube.near_inside, tube.far_inside}) {
            EXPECT_LT(outside(t), -tube.radius);
        }
        EXPECT_GT(outside(tube.far), tube.radius);
    }
}

INSTANTIATE_TEST_SUITE_P(Cameras, DrawnTube, testing::Range(0, int(kinds.size())));

TEST(TubeOfAPixel, WhoseRayPassesTheBoundsByIsEmpty) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.surfaces[0].bounds.radius = 1;
    now.camera.position = {0, 0, 5};
    now.camera.fov = 90;
    const Tubes tubes(now, 64, 64);
    const Tube corner = tubes.at(0, 0), middle = tubes.at(32, 32);
    EXPECT_GT(corner.near, corner.far);
    EXPECT_GT(corner.near_inside, corner.far_inside);
    EXPECT_NEAR(middle.near, -1, 0.01);
    EXPECT_NEAR(middle.far, 1, 0.01);
    // Rows count from the top, columns from the left.
    EXPECT_GT(corner.anchor.y, 0);
    EXPECT_LT(corner.anchor.x, 0);
}

TEST(TubeOfAPixel, BeginsAtAnEyeInsideTheBounds) {
    scene::SceneAt now;
    now.surfaces.resize(1);
    now.surfaces[0].bounds.radius = 1;
    now.camera.position = {0, 0, 0.25};
    now.camera.target = {0, 0, -1};
    const Tube tube = Tubes(now, 1, 1).at(0, 0);
    const glm::dvec3 first = tube.anchor + tube.near * tube.direction;
    EXPECT_NEAR(first.z, 0.25, 1e-4);
    EXPECT_NEAR(tube.anchor.z + tube.far * tube.direction.z, -1, 1e-4);
    // Behind the eye, nothing.
    now.camera.position = {0, 0, -2};
    now.camera.target = {0, 0, -3};
    const Tube behind = Tubes(now, 1, 1).at(0, 0);
    EXPECT_GT(behind.near, behind.far);
}

} // namespace
} // namespace isomotion::roots
