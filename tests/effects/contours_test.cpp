// Contours: a line is as many pixels wide as the scene says, wherever it is seen from.
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

double of_column(const std::vector<double>& part, int column) {
    double sum = 0;
    for (int row = 0; row < side; ++row) sum += part[std::size_t(row * side + column)];
    return sum;
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

const std::string flat = "projection = \"orthographic\"\nposition = [3, 0, 0.0137]\n"
                         "target = [0, 0, 0.0137]\nheight = 1";

// On a plane that faces the eye, lines of z lie across the picture's columns.
TEST(Contours, AreAsWideAsTheySay) {
    for (const double width : {0.5, 1.0, 3.0}) {
        const auto part =
            lines("x", flat, fmt::format("value = \"z\"\nevery = 0.25\nwidth = {}\n", width));
        // At -0.25, 0, 0.25 and 0.5.
        for (const int column : {0, 50, 127}) EXPECT_NEAR(of_column(part, column), 4 * width, 0.02);
        // No pixel is coloured farther off than the width of the line.
        for (int row = 0; row < side; ++row) {
            const double z = 0.0137 + 0.5 - (row + 0.5) / side;
            const double off = std::abs(z - 0.25 * std::round(4 * z)) * side;
            const double expected = std::clamp(0.5 * width + 0.5 - off, 0.0, std::min(1.0, width));
            EXPECT_NEAR(part[std::size_t(row * side + 7)], expected, 0.01) << row;
        }
    }
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

// A number of the place, not of the picture: squares and the surface's own parameters.
TEST(Contours, OfAnyNumberOfThePlace) {
    const auto part = lines("a*x", flat, "value = \"a*z^2 + 0*t\"\nevery = 0.03\nwidth = 1\n",
                            "[parameters]\na = 2\n");
    for (int row = 4; row < side - 4; ++row) {
        const double z = 0.0137 + 0.5 - (row + 0.5) / side;
        const double value = 2 * z * z, change = 4 * std::abs(z) / side;
        if (change < 0.001) continue;
        const double off = std::abs(value - 0.03 * std::round(value / 0.03)) / change;
        EXPECT_NEAR(part[std::size_t(row * side + 7)], std::clamp(1 - off, 0.0, 1.0), 0.02) << row;
    }
}

TEST(Contours, ThatComeTooCloseAreHalfOfThePicture) {
    const auto part = lines("x", flat, "value = \"z\"\nevery = 1e-5\n");
    for (const double some : part) ASSERT_NEAR(some, 0.5, 0.05);
}

// Neither where the number rests, nor where it is none.
TEST(Contours, AreNotWhereTheNumberRests) {
    for (const char* value : {"3", "x", "log(-1 - z^2)", "floor(z)"}) {
        const auto part = lines("x", flat, fmt::format("value = \"{}\"\nevery = 0.5\n", value));
        for (const double some : part) ASSERT_NEAR(some, 0, 1e-6) << value;
    }
}

// With effects, paints and caps: the passes are others and the lines the same.
TEST(Contours, AreTheSameWithEffects) {
    const std::string wanted = "value = \"z\"\nevery = 0.25\n";
    const auto plain = lines("x", flat, wanted);
    for (const char* more : {"[occlusion]\nstrength = 0\n", "[fog]\ndensity = 0\n",
                             "[[sections]]\nnormal = [1, 0, 0]\noffset = 1\n",
                             // a cap in place of the surface
                             "[[sections]]\nnormal = [1, 0, 0]\noffset = -0.5\n"}) {
        const auto with = lines("x", flat, wanted, more);
        for (std::size_t k = 0; k < plain.size(); ++k) ASSERT_NEAR(plain[k], with[k], 1e-4) << more;
    }
}

} // namespace
} // namespace isomotion::render::contours_test
