#include "render/block_squares.h"

#include <random>

#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

TEST(BlockSquares, CoverEachBlockOfTheirKindOnceAndNoOther) {
    const unsigned seed = 1;
    std::mt19937 random(seed);
    for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {97, 61}, {256, 128}, {300, 40}}) {
        // Patches of one kind, so that there is something to join.
        Blocks blocks(width, height);
        for (int k = 0; k < 5; ++k) {
            const int left = int(random() % unsigned(blocks.across));
            const int low = int(random() % unsigned(blocks.up));
            const auto kind = BlockKind(random() % 3);
            for (int y = low; y < blocks.up; ++y)
                for (int x = left; x < blocks.across; ++x) blocks.at(x, y) = kind;
        }
        for (const BlockKind kind : {BlockKind::empty, BlockKind::open, BlockKind::settled}) {
            std::vector<int> covered(blocks.kinds.size());
            for (const auto& [x, y, side] : squares_of(blocks, kind)) {
                ASSERT_EQ(x % side + y % side + side % Blocks::side, 0) << "seed " << seed;
                ASSERT_LE(side, gpu::Squares::longest_side);
                for (int v = y / Blocks::side; v < (y + side) / Blocks::side; ++v)
                    for (int u = x / Blocks::side; u < (x + side) / Blocks::side; ++u)
                        ++covered.at(std::size_t(v * blocks.across + u));
            }
            for (std::size_t k = 0; k < covered.size(); ++k)
                ASSERT_EQ(covered[k], int(blocks.kinds[k] == kind)) << "seed " << seed << ", " << k;
        }
    }
}

TEST(BlockSquares, JoinBlocksOfOneKind) {
    Blocks blocks(256, 256);
    std::ranges::fill(blocks.kinds, BlockKind::open);
    EXPECT_LE(squares_of(blocks, BlockKind::open).size(), blocks.kinds.size() / 16);
}

// A view of bounds by numbers.
struct View {
    FrameBlock frame{};
    bool is_box = false;
    int width = 0, height = 0;
};

View random_view(std::mt19937& random) {
    std::uniform_real_distribution<float> one(-1, 1);
    const auto vector = [&](float size) {
        return size * glm::vec3(one(random), one(random), one(random));
    };
    View view;
    view.is_box = random() % 2 == 0;
    view.width = 40 + int(random() % 200);
    view.height = 40 + int(random() % 200);
    const bool parallel = random() % 2 == 0;
    // As scene::rays(): the eye at origin - axis, the plane of the anchors through the middle of
    // the bounds.
    const glm::vec3 middle = vector(2), axis = vector(1) + glm::vec3(0, 0, 3);
    const glm::vec3 right = glm::normalize(glm::cross(axis, glm::vec3(0.3f, 1, 0.1f)));
    const glm::vec3 up = glm::normalize(glm::cross(right, axis));
    FrameBlock& frame = view.frame;
    frame.ray_origin = glm::vec4(middle + vector(0.5f), 0);
    frame.ray_axis = glm::vec4(axis, parallel ? 0 : 1);
    frame.ray_right = glm::vec4(2.0f * right, 0);
    frame.ray_up = glm::vec4(2.0f * up, 0);
    const glm::vec3 half = glm::abs(vector(1)) + 0.1f;
    frame.bounds_min = view.is_box ? glm::vec4(middle - half, 0) : glm::vec4(middle, half.x);
    frame.bounds_max = glm::vec4(middle + half, 0);
    frame.picture = glm::vec4(2.0f / float(view.width), 2.0f / float(view.height), 0, 0);
    return view;
}

// Whether the ray of a pixel's middle meets the bounds before the eye, by many of its points.
bool meets(const View& view, int x, int y) {
    const FrameBlock& f = view.frame;
    const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) * glm::dvec2(f.picture.x, f.picture.y) - 1.0;
    const glm::dvec3 across = at.x * glm::dvec3(f.ray_right) + at.y * glm::dvec3(f.ray_up);
    const double w = double(f.ray_axis.w);
    for (double tau = -1; tau <= 2; tau += 1.0 / 128) {
        const glm::dvec3 p =
            glm::dvec3(f.ray_origin) + tau * glm::dvec3(f.ray_axis) + (1 + w * tau) * across;
        const bool inside =
            view.is_box ? glm::all(glm::greaterThan(p, glm::dvec3(f.bounds_min))) &&
                              glm::all(glm::lessThan(p, glm::dvec3(f.bounds_max)))
                        : glm::length(p - glm::dvec3(f.bounds_min)) < double(f.bounds_min.w);
        if (inside) return true;
    }
    return false;
}

TEST(BlockSquares, HoldEveryRayThatMeetsTheBounds) {
    const unsigned seed = 2;
    std::mt19937 random(seed);
    int open = 0, needed = 0;
    for (int k = 0; k < 4; ++k) {
        const View view = random_view(random);
        const Blocks blocks =
            blocks_in_bounds(view.frame, view.is_box, {0, 0, view.width, view.height});
        for (int y = 0; y < blocks.up; ++y) {
            for (int x = 0; x < blocks.across; ++x) {
                bool any = false;
                for (int j = 0; j < Blocks::side * Blocks::side && !any; j += 5)
                    any = meets(view, Blocks::side * x + j % 8, Blocks::side * y + j / 8);
                const bool is_open = blocks.at(x, y) == BlockKind::open;
                ASSERT_TRUE(is_open || !any)
                    << "seed " << seed << ", view " << k << ": " << x << " " << y;
                open += is_open;
                needed += any;
            }
        }
    }
    EXPECT_GT(needed, 50);
    EXPECT_LT(open, 1.6 * needed); // few more than are needed
}

TEST(BlockSquares, OfATileAreThoseOfThePicture) {
    std::mt19937 random(3);
    const View view = random_view(random);
    const Blocks whole = blocks_in_bounds(view.frame, view.is_box, {0, 0, view.width, view.height});
    const Blocks tile = blocks_in_bounds(view.frame, view.is_box, {16, 8, 16, 24});
    for (int y = 0; y < tile.up; ++y)
        for (int x = 0; x < tile.across; ++x) EXPECT_EQ(tile.at(x, y), whole.at(x + 2, y + 1));
}

} // namespace
} // namespace isomotion::render
