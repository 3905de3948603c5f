// A file says what is in it.
#include "cli.h"

#include <cmath>

namespace isomotion::cli {
namespace {

class Metadata : public Cli, public testing::WithParamInterface<std::string> {
protected:
    // The metadata as text, whatever types the format keeps.
    static std::string text(const image::Metadata& metadata, const std::string& name) {
        const image::Value* value = image::find(metadata, name);
        return value ? image::to_text(*value) : "(missing)";
    }
};

TEST_P(Metadata, HoldsEverythingTheFrameWasMadeFrom) {
    render({"sphere.toml", "--frames", "31", "--method", "amp-taylor", "--step", "0.02", "--set",
            "camera.fov=35", "-o", "a" + GetParam()});
    const image::Metadata found = image::decode(*this / ("a" + GetParam())).metadata;
    EXPECT_EQ(text(found, "FramesPerSecond"), "30000/1001");
    EXPECT_THAT(text(found, "Software"), StartsWith("isomotion "));
    EXPECT_EQ(text(found, "isomotion:title"), "Sphere");
    EXPECT_EQ(text(found, "isomotion:frame"), "31");
    EXPECT_EQ(text(found, "isomotion:formula"), "x^2 + y^2 + z^2 - r^2");
    EXPECT_EQ(text(found, "isomotion:method"), "amp-taylor");
    EXPECT_EQ(text(found, "isomotion:step"), "0.02");
    EXPECT_EQ(text(found, "isomotion:bisections"), "10");
    EXPECT_EQ(text(found, "isomotion:camera.position"), "[4, 0, 0]");
    EXPECT_EQ(text(found, "isomotion:camera.target"), "[0, 0, 0]");
    EXPECT_EQ(text(found, "isomotion:camera.up"), "[0, 0, 1]");
    EXPECT_EQ(text(found, "isomotion:camera.fov"), "35");
    EXPECT_EQ(text(found, "isomotion:fingerprint").size(), 32u);
    const double time = 30 * 1001.0 / 30000;
    EXPECT_NEAR(std::stod(text(found, "isomotion:time")), time, 1e-12);
    EXPECT_NEAR(std::stod(text(found, "isomotion:parameter.r")), 1 + 0.2 * std::sin(time), 1e-12);
}

TEST_P(Metadata, DiffersFromFrameToFrame) {
    render({"sphere.toml", "--frames", "1-2", "-o", "a.#" + GetParam()});
    const auto first = image::decode(*this / ("a.1" + GetParam())).metadata;
    const auto second = image::decode(*this / ("a.2" + GetParam())).metadata;
    for (const std::string name : {"frame", "time", "parameter.r", "fingerprint"}) {
        EXPECT_NE(text(first, "isomotion:" + name), text(second, "isomotion:" + name)) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Metadata, testing::Values(".png", ".exr"),
                         [](const auto& instance) { return instance.param.substr(1); });

} // namespace
} // namespace isomotion::cli
