// Scenes at the edge of what a formula or an array may be.
#include "cli.h"

#include <algorithm>
#include <cmath>

namespace isomotion::cli {
namespace {

// Balls that lie at random in a cube of edge 1.6. `term` is summed over them.
std::string balls(int count, const std::string& term) {
    return "[surface]\n"
           "formula = \"sum(balls, " +
           term + R"toml() - 0.5"
bounds = { sphere = 1.5 }
[arrays.balls]
cx = "1.6*random(i,0)-0.8"
cy = "1.6*random(i,1)-0.8"
cz = "1.6*random(i,2)-0.8"
count = )toml" +
           std::to_string(count) + "\n[output]\nsize = [48, 48]\n";
}

const std::string distance2 = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

class HardScenes : public Cli {
protected:
    // All channels of the first frame. Warnings are not expected: no pixel is NaN or undecided.
    image::Frame drawn(const std::string& scene, Words more = {},
                       const std::string& warning = {}) const {
        write("scene.toml", scene);
        more.insert(more.begin(), {"scene.toml", "--frames", "1", "-o", "scene.exr", "--channels",
                                   "z,n,p,verdict,evaluations"});
        render(more, warning);
        image::Frame frame = image::decode(*this / "scene.exr");
        for (const auto& channel : frame.channels) {
            EXPECT_TRUE(std::ranges::none_of(channel.samples, [](float v) {
                return std::isnan(v);
            })) << channel.name;
        }
        return frame;
    }
    static std::ptrdiff_t hits(const image::Frame& frame) {
        return std::ranges::count(frame.find("verdict")->samples, 1.0f);
    }
};

TEST_F(HardScenes, NoElementsAreAllBackground) {
    const image::Frame frame = drawn(balls(0, "exp(-30*" + distance2 + ")"), {},
                                     "F is -0.5 to -0.5 everywhere within the bounds");
    EXPECT_EQ(hits(frame), 0);
    for (const char* name : {"R", "G", "B", "A", "Z"}) {
        const auto& samples = frame.find(name)->samples;
        EXPECT_EQ(std::ranges::count(samples, samples[0]), 48 * 48) << name;
    }
    EXPECT_TRUE(std::isinf(frame.find("Z")->samples[0]));
}

// The steps halved, nearly the same rays hit, and at the same depth.
TEST_F(HardScenes, ThousandsOfElements) {
    const std::string scene = balls(5000, "exp(-300*" + distance2 + ")");
    const image::Frame coarse = drawn(scene, {"--size", "16x16", "--step", "0.06"});
    const image::Frame fine = drawn(scene, {"--size", "16x16", "--step", "0.03"});
    EXPECT_GT(hits(coarse), 16 * 16 / 10);
    EXPECT_LT(hits(coarse), 16 * 16);
    std::size_t other = 0;
    for (std::size_t k = 0; k < 16 * 16; ++k) {
        const float a = coarse.find("Z")->samples[k], b = fine.find("Z")->samples[k];
        other += a != b && !(std::abs(a - b) < 1e-3f);
    }
    EXPECT_LE(other, 16 * 16 / 10u);
}

TEST_F(HardScenes, PolesInsideTheSurface) {
    const image::Frame frame = drawn(balls(6, "0.02/" + distance2));
    EXPECT_GT(hits(frame), 48);
    // One more pole exactly in the middle of the picture, on the axis of a centre pixel.
    const image::Frame axis = drawn(R"([surface]
formula = "0.1/(x^2 + y^2 + z^2) - 1"
bounds = { sphere = 1 }
[camera]
position = [4, 0, 0]
[output]
size = [49, 49]
)");
    EXPECT_NEAR(axis.find("Z")->samples[24 * 49 + 24], 4 - std::sqrt(0.1), 1e-3);
}

TEST_F(HardScenes, PowersOfAbsoluteValues) {
    const std::string scene = R"([surface]
formula = "abs(x)^m + abs(y)^m + abs(z)^m - 1"
bounds = { sphere = 1.8 }
[parameters]
m = 2
[camera]
position = [6, 0, 0]
fov = 30
[output]
size = [49, 49]
)";
    // Fat exponents approach the cube, and more rays hit; the axis meets every one at x = 1.
    std::ptrdiff_t before = 0;
    for (const std::string m : {"0.7", "2", "2.5", "200"}) {
        SCOPED_TRACE(m);
        const image::Frame frame = drawn(scene, {"--set", "m=" + m});
        EXPECT_GE(hits(frame), before);
        before = hits(frame);
        EXPECT_EQ(frame.find("verdict")->samples[24 * 49 + 24], 1.0f);
        EXPECT_NEAR(frame.find("Z")->samples[24 * 49 + 24], 5, 1e-3);
    }
    // 3 - 1 = 0 has no solution.
    EXPECT_EQ(hits(drawn(scene, {"--set", "m=0"}, "no ray hits anything")), 0);
}

// Whether a ray that gave up would have met something is not known.
TEST_F(HardScenes, RaysThatGiveUpAreNotSaidToMiss) {
    const std::string scene = R"toml([surface]
formula = "sin(3*x) + sin(3*y) + sin(3*z)"
bounds = { sphere = 2 }
[isolation]
limit = 1
[output]
size = [32, 32]
)toml";
    EXPECT_EQ(hits(drawn(scene, {}, "no ray is known to hit anything: ")), 0);
}

} // namespace
} // namespace isomotion::cli
