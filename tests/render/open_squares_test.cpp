#include "render/open_squares.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isomotion::render::open_squares_test {
namespace {

constexpr auto is_negative = [](float first) { return first < 0; };

// Rows of squares over a whole picture, whose texels are the picture row by row.
std::vector<gpu::Rectangle> rows(int width, int height) {
    std::vector<gpu::Rectangle> all;
    for (int y = 0; y < height; y += OpenSquares::side)
        all.push_back({0, y, width, std::min(OpenSquares::side, height - y)});
    return all;
}

TEST(OpenSquares, OfNothingAreNone) {
    const std::vector<float> record(4 * 40 * 30, 1.0f);
    const OpenSquares found = open_squares(rows(40, 30), record, is_negative);
    EXPECT_EQ(found.pixels, 0);
    EXPECT_TRUE(found.areas.empty());
}

TEST(OpenSquares, JoinNeighboursOfARow) {
    std::vector<float> record(4 * 100 * 33, 1.0f);
    for (const int x : {20, 40, 99}) record[std::size_t(4 * (17 * 100 + x))] = -1;
    const OpenSquares found = open_squares(rows(100, 33), record, is_negative);
    EXPECT_EQ(found.pixels, 3);
    ASSERT_EQ(found.areas.size(), 2u);
    EXPECT_EQ(found.areas[0].x, 16);
    EXPECT_EQ(found.areas[0].width, 32);
    EXPECT_EQ(found.areas[1].x, 96);
    EXPECT_EQ(found.areas[1].width, 4) << "the picture ends there";
    EXPECT_EQ(found.areas[1].y, 16);
    EXPECT_EQ(found.areas[1].height, 16);
}

TEST(OpenSquares, LieInTheAreasThatAreAsked) {
    const std::vector<gpu::Rectangle> areas{{32, 0, 16, 16}, {64, 16, 20, 3}};
    std::vector<float> texels(4 * (16 * 16 + 20 * 3), 1.0f);
    texels[std::size_t(4 * (16 * 16 + 2 * 20 + 18))] = -1; // of the second: 18 right, 2 up
    const OpenSquares found = open_squares(areas, texels, is_negative);
    EXPECT_EQ(found.pixels, 1);
    ASSERT_EQ(found.areas.size(), 1u);
    EXPECT_EQ(found.areas[0].x, 80);
    EXPECT_EQ(found.areas[0].y, 16);
    EXPECT_EQ(found.areas[0].width, 4);
    EXPECT_EQ(found.areas[0].height, 3);
}

// Every open pixel lies in one area, no pixel in two, and no area outside the picture.
TEST(OpenSquares, HoldEveryOpenPixelOnce) {
    constexpr unsigned seed = 20261126;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const auto& [width, height] : {std::pair(1, 1), {16, 16}, {17, 15}, {64, 33}, {5, 90}}) {
        for (const unsigned one_in : {1u, 3u, 40u, 1000u}) {
            std::vector<float> record(std::size_t(4 * width * height), -7.0f); // others don't count
            int open = 0;
            for (std::size_t k = 0; k < record.size(); k += 4) {
                const bool is_open = random() % one_in == 0;
                record[k] = is_open ? -1.0f : 2.0f;
                open += is_open;
            }
            const OpenSquares found = open_squares(rows(width, height), record, is_negative);
            EXPECT_EQ(found.pixels, open);
            std::vector<int> covered(std::size_t(width * height));
            for (const gpu::Rectangle& area : found.areas) {
                ASSERT_GE(area.x, 0);
                ASSERT_LE(area.x + area.width, width);
                ASSERT_LE(area.y + area.height, height);
                for (int y = area.y; y < area.y + area.height; ++y)
                    for (int x = area.x; x < area.x + area.width; ++x)
                        ++covered[std::size_t(y * width + x)];
            }
            for (std::size_t k = 0; k < covered.size(); ++k) {
                EXPECT_LE(covered[k], 1);
                if (record[4 * k] < 0) {
                    EXPECT_EQ(covered[k], 1) << width << " x " << height;
                }
            }
        }
    }
}

} // namespace
} // namespace isomotion::render::open_squares_test
