#include "render/sample_pattern.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

TEST(SamplePattern, BeginsAtTheCentreTheMiddleAndTheOpening) {
    for (int count = 1; count <= 1024; ++count) {
        const auto samples = sample_pattern(count);
        ASSERT_EQ(int(samples.size()), count);
        EXPECT_EQ(samples[0].aim.pixel, glm::dvec2(0));
        EXPECT_EQ(samples[0].aim.lens, glm::dvec2(0));
        EXPECT_EQ(samples[0].part, 0);
    }
}

TEST(SamplePattern, StaysInThePixelOnTheLensAndInTime) {
    std::set<std::pair<double, double>> places, points;
    for (const Sample& s : sample_pattern(1024)) {
        for (int k = 0; k < 2; ++k) {
            EXPECT_GE(s.aim.pixel[k], -0.5);
            EXPECT_LT(s.aim.pixel[k], 0.5);
        }
        EXPECT_LE(glm::length(s.aim.lens), 1 + 1e-15);
        EXPECT_GE(s.part, 0);
        EXPECT_LT(s.part, 1);
        EXPECT_TRUE(places.emplace(s.aim.pixel.x, s.aim.pixel.y).second);
        EXPECT_TRUE(points.emplace(s.aim.lens.x, s.aim.lens.y).second);
    }
}

// Every elementary box of the pixel, 2^a by 2^b of them, holds one of 2^(a + b) points.
TEST(SamplePattern, PowersOfTwoAreNetsInThePixel) {
    for (int m = 0; m <= 10; ++m) {
        const int count = 1 << m;
        const auto samples = sample_pattern(count);
        glm::dvec2 mean(0);
        for (const Sample& s : samples) mean += s.aim.pixel / double(count);
        if (m > 0) {
            EXPECT_EQ(mean, glm::dvec2(-0.5 / count)) << count;
        }
        for (int a = 0; a <= m; ++a) {
            const int columns = 1 << a, rows = 1 << (m - a);
            std::set<std::pair<int, int>> boxes;
            for (const Sample& s : samples) {
                boxes.emplace(int((s.aim.pixel.x + 0.5) * columns),
                              int((s.aim.pixel.y + 0.5) * rows));
            }
            EXPECT_EQ(int(boxes.size()), count) << columns << " by " << rows;
        }
    }
}

// Star discrepancy of the boxes [0, x) x [0, y) whose corners lie on a grid, for each pair of
// coordinates that a picture can mix: far below that of random points, about 1 / sqrt(count).
TEST(SamplePattern, PairsOfCoordinatesHaveLowDiscrepancy) {
    const std::vector<std::function<double(const Sample&)>> coordinates{
        [](const Sample& s) { return s.aim.pixel.x + 0.5; },
        [](const Sample& s) { return s.aim.pixel.y + 0.5; }, [](const Sample& s) { return s.part; },
        [](const Sample& s) { return std::min(glm::dot(s.aim.lens, s.aim.lens), 1.0); },
        [](const Sample& s) { return std::atan2(s.aim.lens.y, s.aim.lens.x) / (2 * M_PI) + 0.5; }};
    for (const int count : {16, 64, 100, 256, 1024}) {
        const auto samples = sample_pattern(count);
        for (std::size_t a = 0; a < coordinates.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                double worst = 0;
                for (int i = 1; i <= 16; ++i) {
                    for (int j = 1; j <= 16; ++j) {
                        const double x = i / 16.0, y = j / 16.0;
                        const auto inside =
                            std::count_if(samples.begin(), samples.end(), [&](const Sample& s) {
                                return coordinates[a](s) < x && coordinates[b](s) < y;
                            });
                        worst = std::max(worst, std::abs(double(inside) / count - x * y));
                    }
                }
                EXPECT_LT(worst, 4.0 / std::pow(count, 0.8)) << count << ": " << a << ", " << b;
            }
        }
    }
}

} // namespace
} // namespace isomotion::render
