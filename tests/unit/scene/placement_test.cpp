#include <fmt/format.h>

#include "testing.h"
#include "unit/formula/testing.h"

namespace isomotion::scene {
namespace {

using formula::Random;

class Placements : public Scenes {
protected:
    PlacementAt placed(const glm::dvec3& translate, const glm::dvec3& rotate, double scale) const {
        const auto list = [](const glm::dvec3& v) {
            return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
        };
        const std::string line =
            fmt::format("bounds = {{ sphere = 1.5 }}\ntransform = {{ translate = {}, rotate = {}, "
                        "scale = {} }}",
                        list(translate), list(rotate), scale);
        return at_time(loaded(ball_with(7, line)), 0).surfaces[0].placement;
    }
};

glm::dvec3 any_point(Random& random, double reach) {
    const auto p = random.point(reach);
    return {p[0], p[1], p[2]};
}

TEST_F(Placements, QuarterTurnsAboutEachAxis) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const auto expect = [&](const glm::dvec3& degrees, const glm::dvec3& from,
                            const glm::dvec3& to) {
        EXPECT_LT(glm::length(placed({}, degrees, 1).to_world(from) - to), 1e-15);
    };
    expect({90, 0, 0}, y, z);
    expect({90, 0, 0}, x, x);
    expect({0, 90, 0}, z, x);
    expect({0, 0, 90}, x, y);
    expect({0, 0, -90}, y, x);
    // About x first, then about the y axis of the world: y goes to z and on to x.
    expect({90, 90, 0}, y, x);
    expect({90, 0, 90}, y, z);
    expect({0, 90, 90}, z, y);
}

// The oracle turns the point about one axis of the world after the other.
TEST_F(Placements, RotateAboutTheFixedAxesOneByOne) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const glm::dvec3 degrees = any_point(random, 400), point = any_point(random, 3);
        glm::dvec3 turned = point;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 about(0);
            about[axis] = 1;
            const double angle = glm::radians(degrees[axis]);
            // Rodrigues' formula.
            turned = turned * std::cos(angle) + glm::cross(about, turned) * std::sin(angle) +
                     about * glm::dot(about, turned) * (1 - std::cos(angle));
        }
        EXPECT_LT(glm::length(placed({}, degrees, 1).to_world(point) - turned), 1e-13);
    }
}

TEST_F(Placements, RotationsKeepLengthsAndHandedness) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const glm::dmat3 r = placed({}, any_point(random, 1000), 1).rotate;
        const glm::dmat3 identity = glm::transpose(r) * r;
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 axis(0);
            axis[k] = 1;
            EXPECT_LT(glm::length(identity[k] - axis), 1e-15);
        }
        EXPECT_NEAR(glm::determinant(r), 1, 1e-15);
    }
}

TEST_F(Placements, ScaleThenRotateThenTranslate) {
    const PlacementAt place = placed({10, 20, 30}, {0, 0, 90}, 4);
    EXPECT_LT(glm::length(place.to_world({1, 0, 0}) - glm::dvec3(10, 24, 30)), 1e-13);
    EXPECT_EQ(place.to_world({0, 0, 0}), glm::dvec3(10, 20, 30));
}

TEST_F(Placements, ThereAndBackIsTheSamePoint) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const double scale = std::exp(random.in(-7, 7)), far = std::exp(random.in(-7, 14));
        const PlacementAt place = placed(any_point(random, far), any_point(random, 360), scale);
        const glm::dvec3 point = any_point(random, 2);
        const double rounding = 1e-15 * (1 + far / scale);
        EXPECT_LT(glm::length(place.to_local(place.to_world(point)) - point), 8 * rounding);
    }
}

} // namespace
} // namespace isomotion::scene
