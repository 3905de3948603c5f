// The maps as the GPU draws them: even steps for every eye.
//
// Colour blindness as Machado, Oliveira & Fernandes (2009) simulate it at full severity: matrices
// for linear sRGB.
#include <cmath>

#include <glm/glm.hpp>

#include "scenes.h"
#include "shader/active_lines.h"
#include "shader/shader_files.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

using Colors = std::vector<glm::dvec3>;

constexpr int steps = 256;

struct Eye {
    const char* name;
    glm::dmat3 rows; // transposed: GLM's matrices are written column by column
};
const std::vector<Eye> eyes{
    {"no deficiency", glm::dmat3(1)},
    {"protanopia",
     {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}},
    {"deuteranopia",
     {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}},
    {"tritanopia",
     {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900}}};

Colors seen(const Eye& eye, Colors colors) {
    for (glm::dvec3& c : colors) c = glm::clamp(c * eye.rows, 0.0, 1.0);
    return colors;
}

// CIELAB's lightness of linear sRGB.
double lightness(const glm::dvec3& c) {
    const double y = glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

// OKLab from linear sRGB (Ottosson 2020): the way back from what the shader does.
glm::dvec3 oklab(const glm::dvec3& c) {
    const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

struct Steps {
    double least = 1e30, most = 0, total = 0;
};

template<class Size> Steps steps_of(const Colors& colors, Size&& size) {
    Steps found;
    for (std::size_t k = 1; k < colors.size(); ++k) {
        const double step = size(colors[k - 1], colors[k]);
        found.least = std::min(found.least, step);
        found.most = std::max(found.most, step);
        found.total += step;
    }
    return found;
}

Steps distances(const Colors& colors) {
    return steps_of(colors,
                    [](const auto& a, const auto& b) { return glm::distance(oklab(a), oklab(b)); });
}

Steps rises(const Colors& colors) {
    return steps_of(colors,
                    [](const auto& a, const auto& b) { return lightness(b) - lightness(a); });
}

// A run of colours that grows lighter evenly.
void expect_even(const Colors& run, double least_lightness_gain) {
    const double mean = 1.0 / double(run.size() - 1);
    for (const glm::dvec3& c : run) {
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(c[k] >= 0 && c[k] <= 1) << "within sRGB";
    }
    const Steps plain = distances(run);
    EXPECT_GT(plain.least, 0.99 * mean * plain.total);
    EXPECT_LT(plain.most, 1.01 * mean * plain.total);
    const double from = lightness(run.front()), to = lightness(run.back());
    for (std::size_t k = 0; k < run.size(); ++k) {
        EXPECT_NEAR(lightness(run[k]), from + (to - from) * double(k) * mean, 1) << k;
    }
    for (const Eye& eye : eyes) {
        SCOPED_TRACE(eye.name);
        const Colors there = seen(eye, run);
        const Steps rise = rises(there), distance = distances(there);
        EXPECT_GT(rise.total, least_lightness_gain);
        EXPECT_GT(rise.least, 0.6 * mean * rise.total) << "lighter at every step";
        EXPECT_GT(distance.least, 0.65 * mean * distance.total);
        EXPECT_GT(distance.total, 0.85 * plain.total) << "no two colours fall together";
    }
}

class ColorMaps : public gpu::EveryBackend {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }

    static Features blue_yellow() {
        Features features;
        features.add(Feature::blue_yellow);
        return features;
    }

    // color_map(k / steps) for k = 0 ... steps.
    static Colors colors_of(Features features) {
        const std::string file = "effects/color_map.glsl";
        const gpu::Program program = gpu::fullscreen_program(
            active_lines(file, read_shader(file), features) + "out vec4 color;\n",
            fmt::format("color = vec4(color_map((gl_FragCoord.x - 0.5) / {}.0), 1.0);", steps));
        const gpu::Target target(steps + 1, 1);
        target.bind();
        program.use();
        gpu::Fullscreen().draw();
        const std::vector<float> pixels = target.read(0, 0, 0, steps + 1, 1);
        Colors colors;
        for (std::size_t k = 0; k < pixels.size(); k += 4) {
            colors.emplace_back(pixels[k], pixels[k + 1], pixels[k + 2]);
        }
        return colors;
    }
};
ISOMOTION_ON_EVERY_BACKEND(ColorMaps);

TEST_P(ColorMaps, BlueYellowGrowsLighterEvenly) { expect_even(colors_of(blue_yellow()), 65); }

TEST_P(ColorMaps, BlueOrangeDoesSoFromBothEnds) {
    const Colors colors = colors_of({});
    const Colors blue(colors.begin(), colors.begin() + steps / 2 + 1);
    const Colors orange(colors.rbegin(), colors.rbegin() + steps / 2 + 1);
    expect_even(blue, 45);
    expect_even(orange, 45);
    EXPECT_NEAR(rises(blue).total, rises(orange).total, 1.5) << "equally steep";
    EXPECT_NEAR(distances(blue).total, distances(orange).total, 1e-3);
}

// The sign of a number is the colour, its size the lightness: whoever sees the picture.
TEST_P(ColorMaps, BlueAndOrangeStayApartAsFarAsTheirNumbers) {
    const Colors colors = colors_of({});
    for (const Eye& eye : eyes) {
        const Colors there = seen(eye, colors);
        for (int k = 1; k <= steps / 2; ++k) {
            const double apart = glm::distance(oklab(there[std::size_t(steps / 2 - k)]),
                                               oklab(there[std::size_t(steps / 2 + k)]));
            EXPECT_GT(apart, 0.12 * k / (steps / 2.0)) << eye.name << " " << k;
        }
    }
}

} // namespace
} // namespace isomotion::shader
