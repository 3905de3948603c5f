// Small linear algebra, against matrices made of known eigenvectors.
#include "topology/field/space_point.h"

#include <gtest/gtest.h>

#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

SpacePoint random_point(formula::Random& random) {
    return {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
}

SpacePoint unit(const SpacePoint& v) { return along({}, 1 / length(v), v); }

// An orthonormal basis.
std::array<SpacePoint, 3> random_axes(formula::Random& random) {
    const SpacePoint a = unit(random_point(random));
    SpacePoint b = random_point(random);
    b = unit(along(b, -dot(a, b), a));
    return {
        a, b, {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

SpaceMatrix matrix_of(const std::array<SpacePoint, 3>& axes, const SpacePoint& values) {
    SpaceMatrix a{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) a[i][j] += values[k] * axes[k][i] * axes[k][j];
        }
    }
    return a;
}

SpacePoint times(const SpaceMatrix& a, const SpacePoint& x) {
    return {dot(a[0], x), dot(a[1], x), dot(a[2], x)};
}

TEST(SpacePoint, EigenvaluesOfRandomMatrices) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        formula::Random random(seed);
        const auto axes = random_axes(random);
        SpacePoint values = random_point(random);
        for (double& value : values) value += value < 0 ? -0.01 : 0.01;
        const SpaceMatrix a = matrix_of(axes, values);

        const auto negative = int(std::ranges::count_if(values, [](double v) { return v < 0; }));
        EXPECT_EQ(inertia(a).negative, negative);
        EXPECT_EQ(inertia(a).positive, 3 - negative);

        const auto least = std::size_t(std::ranges::min_element(values) - values.begin());
        const double gap = std::ranges::min(values) - [&] {
            SpacePoint others = values;
            others[least] = 2;
            return std::ranges::min(others);
        }();
        EXPECT_NEAR(std::abs(dot(least_direction(a), axes[least])), 1, 1e-13 / std::abs(gap));

        const SpacePoint x = random_point(random);
        const auto solved = solve(a, times(a, x));
        ASSERT_TRUE(solved);
        EXPECT_LT(distance(*solved, x), 1e-11);
    }
}

TEST(SpacePoint, SingularMatrices) {
    EXPECT_FALSE(solve(SpaceMatrix{}, {1, 0, 0}));
    EXPECT_FALSE(solve({{{1, 1, 0}, {1, 1, 0}, {0, 0, 1}}}, {1, 0, 0}));
    const Inertia flat = inertia({{{1, 0, 0}, {0, 0, 0}, {0, 0, -1}}});
    EXPECT_EQ(flat.positive, 1);
    EXPECT_EQ(flat.negative, 1);
    EXPECT_EQ(inertia(SpaceMatrix{}).positive, 0);
}

TEST(SpacePoint, DirectionsAlongFreeAxes) {
    // The least eigenvalue's own direction is (1, 1, 0).
    const SpaceMatrix a{{{1, -2, 0}, {-2, 1, 0}, {0, 0, 0.5}}};
    const SpacePoint all = least_direction(a);
    EXPECT_NEAR(std::abs(all[0]), std::sqrt(0.5), 1e-14);
    EXPECT_NEAR(all[0], all[1], 1e-14);
    const SpacePoint some = least_direction(a, {true, false, true});
    EXPECT_EQ(some[1], 0);
    EXPECT_NEAR(std::abs(some[2]), 1, 1e-14);
    EXPECT_EQ(length(least_direction(a, {false, false, false})), 0);
}

} // namespace
} // namespace isomotion::topology
