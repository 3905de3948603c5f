#include "render/packed_rays.h"

#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace isomotion::render::packed_rays_test {
namespace {

bool is_negative(float number) { return number < 0; }

TEST(OpenRays, OfNothingAreNone) {
    EXPECT_TRUE(open_rays({}, {}, is_negative).empty());
    const std::vector<float> texels(4 * 40 * 30, 1.0f);
    const std::vector<gpu::Rectangle> all{{0, 0, 40, 30}};
    EXPECT_TRUE(open_rays(all, texels, is_negative).empty());
}

// Lanes of software renderers that go in step take neighbouring rays.
TEST(OpenRays, ComeSquareBySquare) {
    const std::vector<float> texels(4 * 8 * 4, -1.0f);
    const auto found = open_rays(std::vector<gpu::Rectangle>{{16, 32, 8, 4}}, texels, is_negative);
    ASSERT_EQ(found.size(), 32u);
    for (std::size_t k = 0; k < found.size(); ++k) {
        const int square = int(k) / 16, within = int(k) % 16;
        EXPECT_EQ(found[k].x, 16 + 4 * square + within % 4);
        EXPECT_EQ(found[k].y, 32 + within / 4);
    }
}

// Each is found once, with the place of its own numbers.
TEST(OpenRays, HoldEveryOpenRayOnce) {
    constexpr unsigned seed = 20261127;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 20; ++round) {
        const std::vector<gpu::Rectangle> areas{{0, 0, 1 + int(random() % 40), 16},
                                                {48, 0, 1 + int(random() % 20), 16},
                                                {16, 16, 16, 1 + int(random() % 16)}};
        std::vector<float> texels;
        std::set<std::pair<int, int>> open;
        for (const gpu::Rectangle& area : areas) {
            for (int y = area.y; y < area.y + area.height; ++y) {
                for (int x = area.x; x < area.x + area.width; ++x) {
                    const bool is_open = random() % 5 == 0;
                    if (is_open) open.insert({x, y});
                    texels.insert(texels.end(), {is_open ? -1.0f : 1.0f, float(x), float(y), 0});
                }
            }
        }
        const auto found = open_rays(areas, texels, is_negative);
        EXPECT_EQ(found.size(), open.size());
        for (const OpenRay& ray : found) {
            EXPECT_EQ(open.erase({ray.x, ray.y}), 1u);
            EXPECT_EQ(texels[ray.proof + 1], float(ray.x));
            EXPECT_EQ(texels[ray.proof + 2], float(ray.y));
        }
    }
}

} // namespace
} // namespace isomotion::render::packed_rays_test
