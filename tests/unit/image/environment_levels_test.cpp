// Blurred environment maps, where closed forms and integrals say what they are.
#include "image/environment_levels.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace isomotion::image {
namespace {

using std::numbers::pi;

EnvironmentMap map_of(int width, double (*light)(double x, double y, double z)) {
    EnvironmentMap map{width, width / 2, {}, 0};
    for (int row = 0; row < map.height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double azimuth = pi - 2 * pi * (column + 0.5) / width;
            const double down = pi * (row + 0.5) / map.height;
            const auto value = float(light(std::sin(down) * std::cos(azimuth),
                                           std::sin(down) * std::sin(azimuth), std::cos(down)));
            map.texels.insert(map.texels.end(), {value, 2 * value, 0, 1});
        }
    }
    return map;
}

struct Level {
    int top, width;
};

std::vector<Level> levels_of(int widest) {
    std::vector<Level> levels;
    for (int k = 0, top = 0, width = widest; k < 8; ++k) {
        levels.push_back({top, width});
        top += width / 2;
        width = std::max(width / 2, 32);
    }
    return levels;
}

float red(const EnvironmentMap& map, int column, int row) {
    return map.texels[4 * (std::size_t(row) * std::size_t(map.width) + std::size_t(column))];
}

// The mean of z over the lobe about z, weighted by z: what is left of light that grows with z.
double share_of_slope(double alpha) {
    double sum = 0, weights = 0;
    constexpr int steps = 100'000;
    for (int k = 0; k < steps; ++k) {
        const double part = (k + 0.5) / steps;
        const double z = 2 * (1 - part) / (1 + (alpha * alpha - 1) * part) - 1;
        if (z <= 0) continue;
        sum += z * z;
        weights += z;
    }
    return sum / weights;
}

TEST(EnvironmentLevels, OfTheRoughestMirrorAThirdOfTheSlopeIsLost) {
    EXPECT_NEAR(share_of_slope(1), 2.0 / 3, 1e-4);
}

TEST(EnvironmentLevels, EvenLightStaysAsItIs) {
    const EnvironmentMap levels =
        environment_levels(map_of(64, [](double, double, double) { return 3.0; }), 64);
    for (const Level& level : levels_of(64)) {
        for (int row = 0; row < level.width / 2; ++row) {
            for (int column = 0; column < level.width; ++column)
                ASSERT_NEAR(red(levels, column, level.top + row), 3, 1e-4);
        }
    }
}

// A lobe about n makes 1 + s n.z of 1 + z, and the like along every other axis.
TEST(EnvironmentLevels, LightThatGrowsAlongAnAxisIsFlattenedAsTheLobeSays) {
    constexpr int widest = 128;
    const EnvironmentMap up =
        environment_levels(map_of(256, [](double, double, double z) { return 1 + z; }), widest);
    const EnvironmentMap ahead =
        environment_levels(map_of(256, [](double x, double, double) { return 1 + x; }), widest);
    ASSERT_EQ(up.width, widest);
    double alpha = 1.0 / 128;
    for (const Level& level : levels_of(widest)) {
        const double share = share_of_slope(alpha);
        for (int row = 0; row < level.width / 2; ++row) {
            const double down = 2 * pi * (row + 0.5) / level.width;
            ASSERT_NEAR(red(up, 3, level.top + row), 1 + share * std::cos(down), 0.03)
                << "alpha " << alpha << ", row " << row;
            const int middle = level.width / 2;
            const double x = std::sin(down) * std::cos(pi / level.width);
            ASSERT_NEAR(red(ahead, middle, level.top + row), 1 + share * x, 0.03)
                << "alpha " << alpha << ", row " << row;
        }
        alpha *= 2;
    }
}

// A lamp of a few texels: the rougher, the less of it is seen straight on, and its light is kept.
TEST(EnvironmentLevels, RoughMirrorsSpreadALamp) {
    const EnvironmentMap levels = environment_levels(
        map_of(256, [](double x, double, double) { return x > 0.999 ? 1000.0 : 0.0; }), 256);
    float last = 1001;
    for (const Level& level : levels_of(256)) {
        const float seen = red(levels, level.width / 2, level.top + level.width / 4);
        EXPECT_LT(seen, 1.02f * last);
        EXPECT_GT(seen, 0.0f);
        last = seen;
    }
    // The roughest level weighs by z over the half sphere: it has 1000 times the lamp's part of z.
    EXPECT_NEAR(last, 2, 0.6);
}

TEST(EnvironmentReduction, BlocksBecomeTheirMeans) {
    EnvironmentReduction reduction(2);
    reduction.begin(4, 2);
    std::vector<float> row;
    for (const float v : {1.0f, 3.0f, 10.0f, 20.0f}) row.insert(row.end(), {v, 0, 0, 1});
    reduction.rows(0, row);
    reduction.rows(1, row);
    const EnvironmentMap map = reduction.map();
    EXPECT_EQ(map.width, 2);
    EXPECT_EQ(map.height, 1);
    EXPECT_EQ(map.texels, (std::vector<float>{2, 0, 0, 1, 15, 0, 0, 1}));
}

} // namespace
} // namespace isomotion::image
