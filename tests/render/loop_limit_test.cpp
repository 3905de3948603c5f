// llvmpipe ends every loop of a shader, silently, after 65535 iterations in all. Pictures that need
// more must be right all the same.
#include "render/drawing.h"
#include "render/piled_blobs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render::loop_limit_test {
namespace {

class LoopLimit : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(LoopLimit);

std::string blobs(int count, const std::string& weight) {
    return piled_blobs(count, weight, R"([isolation]
method = "amp-sign"
step = 0.05
near = 0.4
far = 0.49
horizon = 0.5
[output]
size = [32, 32]
)");
}

// The last three of 5,000 blobs are the only ones with weight: a loop that ends early misses them.
TEST_P(LoopLimit, LongSumsAreSummedToTheirEnd) {
    const Picture few = draw(*context, scene_of(blobs(3, "1 + 0*i")));
    scene::Scene long_sum = scene_of(blobs(5001, "max(0, min(1, i - (n - 4)))"));
    long_sum.surfaces[0].isolation.beam = false; // no elements by place
    const Picture many = draw(*context, long_sum);
    EXPECT_GT(count(few, Verdict::hit), 100);
    EXPECT_EQ(few.verdicts, many.verdicts);
    const auto& a = few.frame.find("Z")->samples;
    const auto& b = many.frame.find("Z")->samples;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (std::isfinite(a[k])) {
            EXPECT_NEAR(a[k], b[k], 1e-4);
        }
    }
    EXPECT_GT(many.passes, few.passes);
}

// The same with beams, whose lists leave out all the others, as long as there may be lists and
// beyond.
TEST_P(LoopLimit, BeamsGoThroughLongSums) {
    const auto scene = [](int count, const std::string& weight) {
        return piled_blobs(count, weight, "[isolation]\nbeam = true\n[output]\nsize = [48, 48]\n");
    };
    const Picture few = draw(*context, scene_of(scene(3, "1 + 0*i")));
    EXPECT_GT(count(few, Verdict::hit), 100);
    for (const int blobs : {9'999, 15'000, 15'003}) {
        SCOPED_TRACE(blobs);
        const Picture many = draw(*context, scene_of(scene(blobs, "max(0, min(1, i - (n - 4)))")));
        EXPECT_EQ(few.verdicts, many.verdicts);
    }
}

// 200,000 steps before the surface: three times the driver's limit.
TEST_P(LoopLimit, SmallStepsReachTheSurface) {
    const Picture picture = draw(*context, scene_of(R"(
[surface]
formula = "z"
bounds = { box = [[-1, -1, -0.5], [1, 1, 1]] }
[camera]
position = [0, 0, 3]
up = [0, 1, 0]
fov = 10
[isolation]
method = "marching"
step = 5e-6
limit = 1000000
[output]
size = [4, 4]
)"));
    EXPECT_EQ(count(picture, Verdict::hit), 16);
    EXPECT_GT(picture.evaluations(), 16 * 199'000);
}

TEST_P(LoopLimit, ASumLongerThanAShaderCanLoopIsRefused) {
    const scene::Scene scene = scene_of(blobs(70'000, "1 + 0*i"));
    EXPECT_THROW(draw(*context, scene), std::length_error);
}

} // namespace
} // namespace isomotion::render::loop_limit_test
