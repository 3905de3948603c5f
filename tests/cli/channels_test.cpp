// The channels of a frame tell the truth about a sphere whose every number is known.
#include "cli.h"

#include <algorithm>
#include <cmath>

namespace isomotion::cli {
namespace {

class Channels : public Cli {
protected:
    // The unit sphere from distance 4; odd sizes have a pixel on the axis.
    image::Frame unit_sphere(const std::string& channels) const {
        render({"sphere.toml", "--set", "r=1", "--frames", "1", "--size", "65x49", "--channels",
                channels, "-o", "a.exr"});
        return image::decode(*this / "a.exr");
    }
    static std::set<std::string> channel_names(const image::Frame& frame) {
        std::set<std::string> names;
        for (const auto& channel : frame.channels) names.insert(channel.name);
        return names;
    }
    static double length(const image::Frame& frame, const std::string& layer, std::size_t pixel) {
        return std::hypot(frame.find(layer + ".X")->samples[pixel],
                          frame.find(layer + ".Y")->samples[pixel],
                          frame.find(layer + ".Z")->samples[pixel]);
    }
};

constexpr std::size_t area = 65 * 49, centre = 24 * 65 + 32;

TEST_F(Channels, OfAUnitSphere) {
    const image::Frame frame = unit_sphere("z,n,p,verdict,evaluations");
    ASSERT_EQ(frame.width, 65);
    ASSERT_EQ(frame.height, 49);
    ASSERT_EQ(channel_names(frame),
              (std::set<std::string>{"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "P.X", "P.Y",
                                     "P.Z", "verdict", "evaluations"}));
    EXPECT_NEAR(frame.find("Z")->samples[centre], 3, 1e-3);
    EXPECT_NEAR(frame.find("N.X")->samples[centre], 1, 1e-3);
    EXPECT_NEAR(frame.find("P.X")->samples[centre], 1, 1e-3);
    std::size_t hits = 0;
    for (std::size_t k = 0; k < area; ++k) {
        const float verdict = frame.find("verdict")->samples[k];
        const float depth = frame.find("Z")->samples[k];
        if (verdict == 0) {
            EXPECT_TRUE(std::isinf(depth)) << k;
            continue;
        }
        ASSERT_EQ(verdict, 1) << k;
        ++hits;
        EXPECT_GT(frame.find("evaluations")->samples[k], 0) << k;
        EXPECT_NEAR(length(frame, "N", k), 1, 1e-3) << k;
        EXPECT_NEAR(length(frame, "P", k), 1, 1e-3) << k;
        EXPECT_GE(depth, 2.999f) << k;
        EXPECT_LE(depth, 4) << k;
        // On a unit sphere about the origin, the normal is the position.
        for (const std::string axis : {".X", ".Y", ".Z"}) {
            EXPECT_NEAR(frame.find("N" + axis)->samples[k], frame.find("P" + axis)->samples[k],
                        2e-3);
        }
    }
    // The silhouette is a circle of radius tan(asin(1/4)) / tan(20 degrees) half heights.
    const double radius = 24.5 * std::tan(std::asin(0.25)) / std::tan(20 * M_PI / 180);
    EXPECT_NEAR(double(hits), M_PI * radius * radius, 0.02 * double(area));
}

TEST_F(Channels, OnlyThoseAskedForInAnyOrder) {
    EXPECT_EQ(channel_names(unit_sphere("z")), (std::set<std::string>{"R", "G", "B", "A", "Z"}));
    unit_sphere("verdict,z,z");
    const std::string bytes_of_one = bytes("a.exr");
    unit_sphere("z,verdict");
    EXPECT_EQ(bytes("a.exr"), bytes_of_one);
}

TEST_F(Channels, DoNotChangeThePicture) {
    const image::Frame all = unit_sphere("z,n,p,verdict,evaluations");
    render({"sphere.toml", "--set", "r=1", "--frames", "1", "--size", "65x49", "-o", "b.exr"});
    const image::Frame bare = image::decode(*this / "b.exr");
    for (const char* name : {"R", "G", "B", "A"}) {
        EXPECT_EQ(all.find(name)->samples, bare.find(name)->samples) << name;
    }
}

TEST_F(Channels, PngHoldsEightOrSixteenBits) {
    const auto levels = [&](const std::string& bits) {
        render({"sphere.toml", "--frames", "1", "--size", "96x96", "--bits", bits, "-o",
                "b" + bits + ".png"});
        // Bit depth is the byte after width and height of the first chunk.
        EXPECT_EQ(int(bytes("b" + bits + ".png")[24]), std::stoi(bits));
        const auto samples = image::decode(*this / ("b" + bits + ".png")).find("R")->samples;
        return std::set<float>(samples.begin(), samples.end()).size();
    };
    const std::size_t coarse = levels("8"), fine = levels("16");
    EXPECT_LE(coarse, 256u);
    EXPECT_GT(fine, coarse);
    const auto a = image::decode(*this / "b8.png"), b = image::decode(*this / "b16.png");
    for (std::size_t k = 0; k < 96 * 96; ++k) {
        ASSERT_NEAR(a.find("G")->samples[k], b.find("G")->samples[k], 0.005) << k;
    }
}

} // namespace
} // namespace isomotion::cli
