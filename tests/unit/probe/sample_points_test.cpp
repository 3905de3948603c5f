#include "probe/sample_points.h"

#include <gtest/gtest.h>

namespace isomotion::probe {
namespace {

TEST(SamplePoints, AreHaltons) {
    const double by_two[] = {0.5, 0.25, 0.75, 0.125}, by_three[] = {1, 2, 1.0 / 3, 4.0 / 3};
    for (int k = 1; k <= 4; ++k) {
        EXPECT_EQ(halton(k, 2), by_two[k - 1]);
        EXPECT_NEAR(halton(k, 3), by_three[k - 1] / 3, 1e-15);
    }
}

// An eighth of the points for each octant of the box, and of these in the ball as its volume says.
TEST(SamplePoints, FillTheBoxEvenly) {
    scene::BoundsAt bounds;
    bounds.centre = {1, 2, 3};
    bounds.radius = 2;
    bounds.min = bounds.centre - 2.0;
    bounds.max = bounds.centre + 2.0;
    constexpr int count = 4096;
    int octants[8] = {}, inside = 0;
    for (int k = 1; k <= count; ++k) {
        const glm::dvec3 p = sample_point(bounds, k), from = p - bounds.centre;
        ++octants[(from.x < 0) + 2 * (from.y < 0) + 4 * (from.z < 0)];
        inside += is_in(bounds, p);
        bounds.shape = scene::Bounds::Shape::box;
        EXPECT_TRUE(is_in(bounds, p));
        EXPECT_FALSE(is_in(bounds, p + glm::dvec3(0, 4, 0)));
        bounds.shape = scene::Bounds::Shape::sphere;
    }
    for (const int in_octant : octants) EXPECT_NEAR(in_octant, count / 8, 8);
    EXPECT_NEAR(double(inside) / count, 0.5236, 0.005);
}

} // namespace
} // namespace isomotion::probe
