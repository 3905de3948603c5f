#include "scene/rays.h"

#include <cmath>

#include <gmock/gmock.h>

#include "unit/formula/testing.h"

namespace isomotion::scene {
namespace {

using formula::Random;

glm::dvec3 any_vector(Random& random, double reach) {
    const auto p = random.point(reach);
    return {p[0], p[1], p[2]};
}

glm::dmat3 any_rotation(Random& random) {
    const glm::dvec3 a = glm::normalize(any_vector(random, 1));
    const glm::dvec3 b = glm::normalize(glm::cross(a, any_vector(random, 1)));
    return {a, b, glm::cross(a, b)};
}

SceneAt any_scene(Random& random) {
    SceneAt scene;
    scene.surfaces.resize(1);
    scene.surfaces[0].bounds.centre = any_vector(random, 2);
    scene.surfaces[0].bounds.radius = std::exp(random.in(-2, 2));
    scene.surfaces[0].placement.translate = any_vector(random, 10);
    scene.surfaces[0].placement.rotate = any_rotation(random);
    scene.surfaces[0].placement.scale = std::exp(random.in(-2, 2));
    scene.camera.position = any_vector(random, 20);
    scene.camera.target = any_vector(random, 20);
    scene.camera.up = any_vector(random, 1);
    scene.camera.fov = random.in(1, 150);
    return scene;
}

// A camera `distance` from the bounds, looking at them, in whose picture they are `part` large.
SceneAt looking_at_bounds(Random& random, double distance, double part) {
    SceneAt scene = any_scene(random);
    scene.camera.target = scene.surfaces[0].placement.to_world(scene.surfaces[0].bounds.centre);
    scene.camera.position = scene.camera.target + distance * glm::normalize(any_vector(random, 1));
    const double half =
        scene.surfaces[0].bounds.radius * scene.surfaces[0].placement.scale / (part * distance);
    scene.camera.fov = glm::degrees(2 * std::atan(half));
    return scene;
}

glm::dvec3 along(const Rays& r, const glm::dvec2& at) {
    return r.axis + at.x * r.right + at.y * r.up;
}
glm::dvec3 anchor(const Rays& r, const glm::dvec2& at) {
    return r.origin + at.x * r.right + at.y * r.up;
}

glm::dvec2 any_pixel(Random& random) { return {random.in(-1, 1), random.in(-1, 1)}; }

template<class Check> void for_many_seeds(Check&& check) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const int width = 1 + random.below(2000), height = 1 + random.below(2000);
        check(random, width, height);
    }
}

TEST(Rays, PassThroughTheEye) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_scene(random);
        const Rays r = rays(scene, width, height);
        const glm::dvec3 eye = scene.surfaces[0].placement.to_local(scene.camera.position);
        const double size = glm::length(eye) + glm::length(r.axis);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec2 at = any_pixel(random);
            const glm::dvec3 direction = glm::normalize(along(r, at));
            const glm::dvec3 back = anchor(r, at) - direction * glm::length(along(r, at));
            EXPECT_LT(glm::length(back - eye), 1e-14 * (size + glm::length(along(r, at))));
        }
    });
}

TEST(Rays, AnchorsLieOnThePlaneThroughTheBounds) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_scene(random);
        const Rays r = rays(scene, width, height);
        const double depth = glm::length(r.axis);
        const glm::dvec3 forward = r.axis / depth;
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 off = anchor(r, any_pixel(random)) - r.origin;
            EXPECT_NEAR(glm::dot(off, forward), 0,
                        1e-15 * (glm::length(r.origin) + glm::length(off)));
        }
        const glm::dvec3 eye = scene.surfaces[0].placement.to_local(scene.camera.position);
        const double to_bounds = glm::dot(scene.surfaces[0].bounds.centre - eye, forward);
        if (to_bounds > 0.5 * scene.surfaces[0].bounds.radius) {
            EXPECT_NEAR(glm::dot(r.origin - scene.surfaces[0].bounds.centre, forward), 0,
                        1e-13 * (1 + depth));
        } else {
            EXPECT_DOUBLE_EQ(depth, 0.5 * scene.surfaces[0].bounds.radius);
        }
    });
}

// The oracle is a pinhole camera in the world: forward, right and up of the viewer.
TEST(Rays, AreThoseOfAPinholeCamera) {
    for_many_seeds([](Random& random, int width, int height) {
        const double aspect = double(width) / height;
        const SceneAt scene = any_scene(random);
        const Rays r = rays(scene, width, height);
        const CameraAt& camera = scene.camera;
        const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
        const glm::dvec3 up = glm::cross(right, forward);
        const double half = std::tan(glm::radians(camera.fov) / 2);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec2 at = any_pixel(random);
            const glm::dvec3 expected =
                glm::normalize(forward + at.x * half * aspect * right + at.y * half * up);
            const glm::dvec3 direction =
                scene.surfaces[0].placement.rotate * glm::normalize(along(r, at));
            EXPECT_LT(glm::length(direction - expected), 1e-13);
        }
    });
}

TEST(Rays, TheMiddleLooksAtTheTarget) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_scene(random);
        const Rays r = rays(scene, width, height);
        const glm::dvec3 eye = r.origin - r.axis;
        const glm::dvec3 to_target =
            scene.surfaces[0].placement.to_local(scene.camera.target) - eye;
        EXPECT_LT(glm::length(glm::normalize(to_target) - glm::normalize(r.axis)), 1e-12);
        // A picture of odd size has a pixel there.
        EXPECT_EQ(anchor(r, {0, 0}), r.origin);
    });
}

// Everything in the world scaled and moved together, the formula's coordinates are the same.
TEST(Rays, DoNotDependOnTheWorldsUnitsAndOrigin) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_scene(random);
        const Rays here = rays(scene, width, height);
        const auto expect_same = [&](const SceneAt& other, double tolerance) {
            const Rays there = rays(other, width, height);
            const double size = glm::length(here.axis) + glm::length(here.right) +
                                glm::length(here.up) + scene.surfaces[0].bounds.radius;
            EXPECT_LT(glm::length(there.origin - here.origin), tolerance * size);
            EXPECT_LT(glm::length(there.axis - here.axis), tolerance * size);
            EXPECT_LT(glm::length(there.right - here.right), tolerance * size);
            EXPECT_LT(glm::length(there.up - here.up), tolerance * size);
        };
        SceneAt large = scene;
        large.surfaces[0].placement.scale *= 1000;
        for (glm::dvec3* p : {&large.surfaces[0].placement.translate, &large.camera.position,
                              &large.camera.target}) {
            *p *= 1000;
        }
        expect_same(large, 1e-12);

        SceneAt moved = scene;
        const glm::dvec3 by(1e6, -1e6, 1e6);
        for (glm::dvec3* p : {&moved.surfaces[0].placement.translate, &moved.camera.position,
                              &moved.camera.target}) {
            *p += by;
        }
        // Coordinates of 10^6 keep ten digits behind the point; small scales magnify what is lost.
        expect_same(moved, 1e-9 * std::max(1.0, 1 / scene.surfaces[0].placement.scale));
    });
}

TEST(Rays, AnchorsKeepTheSizeOfTheBoundsWhenTheCameraIsFar) {
    for_many_seeds([](Random& random, int, int) {
        for (const double distance : {1e3, 1e5, 1e7}) {
            SceneAt scene = looking_at_bounds(random, distance, 0.9);
            const Rays r = rays(scene, 512, 512);
            const double reach =
                glm::length(scene.surfaces[0].bounds.centre) + 2 * scene.surfaces[0].bounds.radius;
            for (int k = 0; k < 20; ++k) {
                const glm::dvec3 a = anchor(r, any_pixel(random));
                EXPECT_LT(glm::length(a), reach);
                // As floats they are as good as floats near the bounds can be.
                EXPECT_LT(glm::length(glm::dvec3(glm::vec3(a)) - a), 1e-7 * reach);
            }
            EXPECT_LT(glm::length(r.origin - scene.surfaces[0].bounds.centre),
                      1e-14 * distance / scene.surfaces[0].placement.scale + 1e-13 * reach);
        }
    });
}

TEST(Rays, LookingAlongUpIsUpright) {
    for_many_seeds([](Random& random, int width, int height) {
        const double aspect = double(width) / height;
        SceneAt scene = any_scene(random);
        for (const double sign : {1.0, -1.0}) {
            scene.camera.up = sign * 0.3 * (scene.camera.target - scene.camera.position);
            const Rays r = rays(scene, width, height);
            const double half = std::tan(glm::radians(scene.camera.fov) / 2) * glm::length(r.axis);
            EXPECT_NEAR(glm::length(r.up), half, 1e-13 * half);
            EXPECT_NEAR(glm::length(r.right), half * aspect, 1e-13 * half * aspect);
            EXPECT_NEAR(glm::dot(glm::normalize(r.up), glm::normalize(r.right)), 0, 1e-14);
            EXPECT_NEAR(glm::dot(glm::normalize(r.up), glm::normalize(r.axis)), 0, 1e-14);
        }
    });
}

TEST(Rays, RightIsRightAndUpIsUp) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_scene(random);
        const Rays r = rays(scene, width, height);
        EXPECT_GT(glm::dot(scene.surfaces[0].placement.rotate * r.up, scene.camera.up), 0);
        // A right-handed frame: right, up, and back to the viewer.
        EXPECT_LT(glm::dot(glm::cross(r.right, r.up), r.axis), 0);
    });
}

TEST(Rays, OfAPictureByHand) {
    SceneAt scene;
    scene.surfaces.resize(1);
    scene.camera = {{4, 0, 0}, {0, 0, 0}, {0, 0, 1}, 90};
    const Rays r = rays(scene, 200, 100);
    EXPECT_LT(glm::length(r.origin - glm::dvec3(0)), 1e-15);
    EXPECT_LT(glm::length(r.axis - glm::dvec3(-4, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(r.right - glm::dvec3(0, 8, 0)), 1e-14);
    EXPECT_LT(glm::length(r.up - glm::dvec3(0, 0, 4)), 1e-14);
}

TEST(Rays, FromInsideTheBoundsAndBeforeThem) {
    for (const double x : {0.0, 0.2, -0.2, 5.0}) {
        SceneAt scene;
        scene.surfaces.resize(1);
        scene.camera = {{x, 0, 0}, {x + 1, 0, 0}, {0, 0, 1}, 60};
        const Rays r = rays(scene, 64, 64);
        EXPECT_LT(glm::length(r.origin - r.axis - scene.camera.position), 1e-15) << x;
        EXPECT_GE(glm::length(r.axis), 0.5) << x;
    }
}

SceneAt any_lens(Random& random, bool parallel) {
    SceneAt scene = any_scene(random);
    scene.camera.aperture = std::exp(random.in(-3, 1));
    scene.camera.focus = std::exp(random.in(-1, 3));
    scene.camera.height = std::exp(random.in(-1, 3));
    if (parallel) scene.camera.projection = Camera::Projection::orthographic;
    return scene;
}
// The direction of a ray by the rule in rays.h, perspective or parallel.
glm::dvec3 towards(const Rays& r, const glm::dvec2& at) {
    return r.parallel ? r.axis : along(r, at);
}
void expect_same(const Rays& a, const Rays& b) {
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.axis, b.axis);
    EXPECT_EQ(a.right, b.right);
    EXPECT_EQ(a.up, b.up);
}

TEST(Rays, WithoutAnAimAreThoseOfPixelCentres) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_lens(random, random.in(0, 1) < 0.5);
        expect_same(rays(scene, width, height), rays(scene, width, height, {}));
    });
}

// Half a pixel to the right of one centre and to the left of the next is the same ray.
TEST(Rays, AnOffsetOfPixelsIsAnotherPlaceInThePicture) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_lens(random, random.in(0, 1) < 0.5);
        const glm::dvec2 at = any_pixel(random), offset = any_pixel(random);
        const Rays still = rays(scene, width, height),
                   moved = rays(scene, width, height, {offset, {0, 0}});
        const glm::dvec2 there = at + 2.0 * offset / glm::dvec2(width, height);
        const double size = glm::length(still.origin) + glm::length(along(still, there));
        EXPECT_LT(glm::length(anchor(moved, at) - anchor(still, there)), 1e-12 * size);
        EXPECT_LT(glm::length(towards(moved, at) - towards(still, there)), 1e-12 * size);
    });
}

// From wherever on the lens, a pixel's ray begins there and meets the plane in focus in one point.
TEST(Rays, OfALensMeetInFocus) {
    for_many_seeds([](Random& random, int width, int height) {
        for (const bool parallel : {false, true}) {
            const SceneAt scene = any_lens(random, parallel);
            const glm::dvec2 at = any_pixel(random), lens = 0.7 * any_pixel(random);
            const Rays still = rays(scene, width, height),
                       moved = rays(scene, width, height, {{0, 0}, lens});
            const double in_focus =
                scene.camera.focus / scene.surfaces[0].placement.scale / glm::length(still.axis);
            const auto seen = [&](const Rays& r, double depth) {
                return anchor(r, at) + (depth - 1) * towards(r, at);
            };
            const double size =
                (1 + in_focus) * (glm::length(still.origin) + glm::length(along(still, at)) +
                                  glm::length(moved.axis));
            EXPECT_LT(glm::length(seen(moved, in_focus) - seen(still, in_focus)), 1e-12 * size);
            const glm::dvec3 place = seen(moved, 0) - seen(still, 0);
            EXPECT_NEAR(glm::length(place) * scene.surfaces[0].placement.scale,
                        scene.camera.aperture / 2 * glm::length(lens),
                        1e-12 * size * scene.surfaces[0].placement.scale);
            EXPECT_NEAR(glm::dot(place, glm::normalize(still.axis)), 0, 1e-12 * size);
        }
    });
}

TEST(Rays, OfALensAreTheSameInFormulaCoordinates) {
    for_many_seeds([](Random& random, int width, int height) {
        const SceneAt scene = any_lens(random, random.in(0, 1) < 0.5);
        const Aim aim{0.5 * any_pixel(random), 0.7 * any_pixel(random)};
        const Rays a = rays(scene, width, height, aim),
                   b = rays(in_formula_coordinates(scene), width, height, aim);
        const double size = glm::length(a.origin) + glm::length(a.axis) +
                            scene.camera.aperture / scene.surfaces[0].placement.scale;
        EXPECT_LT(glm::length(a.origin - b.origin), 1e-9 * size);
        EXPECT_LT(glm::length(a.axis - b.axis), 1e-9 * size);
    });
}

} // namespace
} // namespace isomotion::scene
