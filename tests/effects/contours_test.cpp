// Contours: a line is as many pixels wide as the scene says, wherever it is seen from
// (scenes/contours.toml has the rest).
#include <cmath>

#include <fmt/format.h>

#include "render/drawing.h"

namespace isomotion::render::contours_test {
namespace {

gpu::Context& context_of_contours() {
    static const auto it = gpu::Context::create();
    return *it;
}

constexpr int side = 128;

// White under one light from the eye, with black lines: how much of each pixel is line.
std::vector<double> lines(const std::string& surface, const std::string& camera,
                          const std::string& contours, const std::string& more = {}) {
    const std::string text =
        fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ box = [[-4, -4, -4], [4, 4, 4]] }}\n"
                    "[camera]\n{}\n[output]\nsize = [{}, {}]\n{}[material]\ncolor = [1, 1, 1]\n",
                    surface, camera, side, side, more);
    const Picture plain = draw(context_of_contours(), scene_of(text));
    const Picture lined =
        draw(context_of_contours(), scene_of(text + "[material.contours]\n" + contours));
    const auto &white = plain.frame.find("R")->samples, &drawn = lined.frame.find("R")->samples;
    std::vector<double> part;
    for (std::size_t k = 0; k < white.size(); ++k)
        part.push_back(1 - double(drawn[k]) / double(white[k]));
    return part;
}

// The width of each line across a column, except those that the picture's edge cuts.
std::vector<double> widths_in_column(const std::vector<double>& part, int column) {
    std::vector<double> widths;
    double width = 0;
    bool is_whole = false;
    for (int row = 0; row < side; ++row) {
        const double some = part[std::size_t(row * side + column)];
        if (some > 1e-4) {
            width += some;
            continue;
        }
        if (width > 0 && is_whole) widths.push_back(width);
        width = 0;
        is_whole = true;
    }
    return widths;
}

TEST(Contours, AreAsWideFromAnyDistanceAndOnAnySlope) {
    for (const char* plane : {"x", "x + z", "x - 3*z", "x + 0.5*y + z"}) {
        for (const double distance : {2.0, 20.0, 2000.0}) {
            SCOPED_TRACE(fmt::format("{} from {}", plane, distance));
            // As much in view from each.
            const double fov = 2 * std::atan(0.5 / distance) * 180 / std::acos(-1.0);
            const auto part = lines(plane,
                                    fmt::format("position = [{}, 0, 0]\ntarget = [0, 0, 0]\n"
                                                "fov = {}",
                                                distance, fov),
                                    "value = \"z\"\nevery = 0.5\nfrom = 0.1\n");
            const std::vector<double> widths = widths_in_column(part, side / 2);
            EXPECT_FALSE(widths.empty());
            for (const double width : widths) EXPECT_NEAR(width, 1, 0.06);
        }
    }
}

} // namespace
} // namespace isomotion::render::contours_test
