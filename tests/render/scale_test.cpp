// Scaled and moved with its camera, a scene gives the same picture: the placement is applied to the
// rays on the CPU, in double.
#include "render/drawing.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace isomotion::render {
namespace {

class Scale : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Scale);

std::string placed(double scale, double offset) {
    return fmt::format(R"(
[surface]
formula = "x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 0.3"
bounds = {{ sphere = 1.6 }}
transform = {{ translate = [{0}, {1}, {0}], scale = {2} }}
[camera]
position = [{3}, {4}, {5}]
target = [{0}, {1}, {0}]
fov = 40
[isolation]
step = 0.02
near = 0.1
far = 0.4
horizon = 0.2
[output]
size = [96, 96]
)",
                       offset, -2 * offset, scale, offset + 4 * scale, -2 * offset + 2 * scale,
                       offset + 1.5 * scale);
}

TEST_P(Scale, PlacementChangesNoVerdict) {
    const Picture unit = draw(*context, scene_of(placed(1, 0)));
    EXPECT_GT(count(unit, Verdict::hit), 1000);
    for (const auto& [scale, offset] : std::vector<std::pair<double, double>>{
             {1e-3, 0}, {1e3, 0}, {1e6, 0}, {1, 1e6}, {1e3, 1e6}}) {
        SCOPED_TRACE(fmt::format("scale {}, moved by {}", scale, offset));
        const Picture moved = draw(*context, scene_of(placed(scale, offset)));
        const auto& a = unit.frame.find("verdict")->samples;
        const auto& b = moved.frame.find("verdict")->samples;
        int different = 0;
        for (std::size_t k = 0; k < a.size(); ++k) different += a[k] != b[k];
        // Rays differ by rounding: at most a pixel on the silhouette.
        EXPECT_LE(different, 2);
    }
}

TEST_P(Scale, AFarCameraSeesTheSameAsANearOne) {
    // The angle under which the bounds appear is kept; perspective vanishes, jitter must not come.
    const auto seen = [&](double distance) {
        const double fov = 2 * std::atan(2 / distance) * 180 / M_PI;
        std::string text = sphere_scene;
        text.replace(text.find("[5, 0, 0]"), 9, fmt::format("[{}, 0, 0]", distance));
        text.replace(text.find("fov = 40"), 8, fmt::format("fov = {}", fov));
        return draw(*context, scene_of(text));
    };
    const Picture near = seen(1e3), far = seen(1e5);
    const auto hits = count(near, Verdict::hit);
    EXPECT_NEAR(double(hits), M_PI * 30 * 30, 60); // a disc of radius 1 in a picture 4 high
    EXPECT_NEAR(double(count(far, Verdict::hit)), double(hits), 16);
    const auto& x = far.frame.find("P.X")->samples;
    const auto& y = far.frame.find("P.Y")->samples;
    const auto& z = far.frame.find("P.Z")->samples;
    const auto& verdict = far.frame.find("verdict")->samples;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (verdict[k] == 1) {
            EXPECT_NEAR(std::hypot(x[k], y[k], z[k]), 1, 1e-4);
        }
    }
}

} // namespace
} // namespace isomotion::render
