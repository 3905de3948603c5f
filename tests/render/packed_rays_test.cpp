#include "render/packed_rays.h"

#include <gtest/gtest.h>

namespace isomotion::render::packed_rays_test {
namespace {

TEST(PackedSquares, HoldAllAndAreHardlyMore) {
    for (int squares = 1; squares <= PackedRays::most / 16; squares += 1 + squares / 500) {
        const glm::ivec2 drawn = packed_squares(squares);
        EXPECT_GE(drawn.x * drawn.y, squares);
        EXPECT_LE(drawn.x * drawn.y, squares + 3 + squares / 50) << squares;
    }
}

} // namespace
} // namespace isomotion::render::packed_rays_test
