// Level sets hold the places where the polynomial is below the level, and little more.
#include "elements/quadric.h"

#include <random>

#include <gtest/gtest.h>

namespace isomotion::elements {
namespace {

// (p - centre)' H (p - centre) / 2 + least, written about the origin.
std::array<double, 10> written_out(const Symmetric& h, const glm::dvec3& centre, double least) {
    const glm::dvec3 slope = -(h * centre);
    const double value = least + 0.5 * glm::dot(centre, h * centre);
    return {value, slope.x, slope.y, slope.z, h.xx, h.xy, h.xz, h.yy, h.yz, h.zz};
}

class Drawn {
public:
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

private:
    std::mt19937 engine_{11};
};

TEST(Quadric, LevelSetsHoldWhatIsBelowTheLevel) {
    Drawn draw;
    for (int turn = 0; turn < 300; ++turn) {
        const Symmetric h{draw(1, 9), draw(-.4, .4), draw(-.4, .4),
                          draw(1, 9), draw(-.4, .4), draw(1, 9)};
        const glm::dvec3 centre(draw(-3, 3), draw(-3, 3), draw(-3, 3));
        const double sign = turn % 2 ? 1 : -1, least = draw(-2, 2);
        std::array<double, 10> q = written_out(h, centre, least);
        for (double& c : q) c *= sign;
        const Quadric quadric = Quadric::from(q, {glm::dvec3(-4), glm::dvec3(4)});
        ASSERT_TRUE(quadric.is_definite);
        EXPECT_EQ(quadric.sign, sign);
        EXPECT_NEAR(quadric.least, least, 1e-9);
        const double level = least + draw(0.01, 3);
        const LevelSet set = quadric.level_set(level);
        ASSERT_EQ(set.kind, LevelSet::Kind::bounded);
        glm::dvec3 farthest(0);
        for (int k = 0; k < 200; ++k) {
            // On the level's surface.
            glm::dvec3 d(draw(-1, 1), draw(-1, 1), draw(-1, 1));
            d *= std::sqrt(2 * (level - least) / glm::dot(d, h * d));
            EXPECT_LE(glm::dot(d, set.form * d), 1);
            EXPECT_GT(glm::dot(d, set.form * d), 1 - 1e-5);
            farthest = glm::max(farthest, glm::abs(d));
            for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(d[axis]), set.half[axis]);
        }
        for (int axis = 0; axis < 3; ++axis) EXPECT_GT(farthest[axis], 0.7 * set.half[axis]);
    }
}

TEST(Quadric, OthersAreNotDefinite) {
    const Region region{glm::dvec3(-1), glm::dvec3(1)};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Symmetric& h :
         {Symmetric{1, 0, 0, 1, 0, -1}, Symmetric{0, 0, 0, 0, 0, 0}, Symmetric{1, 0, 0, 1, 1, 0},
          Symmetric{1, 2, 0, 1, 0, 1}, Symmetric{nan, 0, 0, 1, 0, 1},
          Symmetric{1e300, 0, 0, 1e300, 0, 1e300}}) {
        EXPECT_FALSE(Quadric::from(written_out(h, glm::dvec3(0), 0), region).is_definite);
    }
}

// Kernels of a distance from a line, or from a plane.
TEST(Quadric, MayBeFlatAlongAxes) {
    const Region region{glm::dvec3(-1, -1, 3), glm::dvec3(1, 1, 5)};
    const Quadric line =
        Quadric::from(written_out({2, 0.5, 0, 3, 0, 0}, {0.5, -0.25, 0}, 1), region);
    ASSERT_TRUE(line.is_definite);
    EXPECT_EQ(line.is_flat, glm::bvec3(false, false, true));
    EXPECT_NEAR(glm::length(line.centre - glm::dvec3(0.5, -0.25, 4)), 0, 1e-12);
    const LevelSet set = line.level_set(2);
    ASSERT_EQ(set.kind, LevelSet::Kind::bounded);
    EXPECT_GE(set.half.z, 2) << "all of the region";
    EXPECT_EQ(set.form.zz, 0);
    EXPECT_LT(set.half.x, 1.2);
    EXPECT_LE(line.flattest * 0.01, 0.5 * 3 * 0.01) << "at most what it is along y";
    EXPECT_GT(line.flattest, 0.5);
    const Quadric plane = Quadric::from(written_out({0, 0, 0, 8, 0, 0}, {0, 0.5, 0}, 0), region);
    ASSERT_TRUE(plane.is_definite);
    EXPECT_NEAR(plane.level_set(1).half.y, 0.5, 1e-5);
    // Linear along an axis is not flat.
    std::array<double, 10> q = written_out({2, 0, 0, 3, 0, 0}, glm::dvec3(0), 0);
    q[3] = 1;
    EXPECT_FALSE(Quadric::from(q, region).is_definite);
}

} // namespace
} // namespace isomotion::elements
