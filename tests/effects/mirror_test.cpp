// Mirrors and what is around, where the closed form says.
#include <cmath>

#include <fmt/format.h>

#include "image/environment.h"
#include "render/drawing.h"

namespace isomotion::render {
namespace {

const std::string studio = ISOMOTION_SOURCE_DIR "/media/studio.exr";

std::string ball(const std::string& more) {
    return fmt::format("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = {{ sphere = 1.2 }}\n"
                       "[camera]\nposition = [3, 2, 1]\ntarget = [0, 0, 0]\nup = [0, 0, 1]\n"
                       "fov = 50\n[[lights]]\ndirection = [0, 0, 1]\ncolor = [0, 0, 0]\n"
                       "[environment]\nmap = \"{}\"\n{}\n[output]\nsize = [96, 96]\n",
                       studio, more);
}

// A texel of the map in double, bilinear; the middle looks along x, its left quarter along y.
glm::dvec3 looked_up(const image::EnvironmentMap& map, const glm::dvec3& d) {
    const double u = (0.5 - std::atan2(d.y, d.x) / (2 * M_PI)) * map.width - 0.5;
    const double v = std::acos(std::clamp(d.z, -1.0, 1.0)) / M_PI * map.height - 0.5;
    const auto texel = [&](int column, int row) {
        column = (column % map.width + map.width) % map.width;
        row = std::clamp(row, 0, map.height - 1);
        const float* t =
            &map.texels[4 * (std::size_t(row) * std::size_t(map.width) + std::size_t(column))];
        return glm::dvec3(t[0], t[1], t[2]);
    };
    const int column = int(std::floor(u)), row = int(std::floor(v));
    const double x = u - column, y = v - row;
    return glm::mix(glm::mix(texel(column, row), texel(column + 1, row), x),
                    glm::mix(texel(column, row + 1), texel(column + 1, row + 1), x), y);
}

class Mirror : public Drawing {
protected:
    const image::EnvironmentMap map = image::read_environment(studio);
    static glm::dvec3 color(const Picture& picture, std::size_t pixel) {
        glm::dvec3 c;
        for (int k = 0; k < 3; ++k) {
            c[k] = picture.frame.channels[std::size_t(k)].samples[pixel];
        }
        return c;
    }
    static bool is_hit(const Picture& picture, std::size_t pixel) {
        return picture.frame.find("verdict")->samples[pixel] == float(Verdict::hit);
    }
};
ISOMOTION_ON_EVERY_BACKEND(Mirror);

// The map is soft but for the edges of its lamps, where a hundredth of a texel shows.
void expect_near(const glm::dvec3& found, const glm::dvec3& expected, std::size_t pixel) {
    for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(found[k], expected[k], 0.01 + 0.02 * expected[k]) << "pixel " << pixel;
    }
}

TEST_P(Mirror, ABallShowsTheMapWhereTheLawOfReflectionSays) {
    const scene::Scene scene = scene_of(
        ball("[material]\nmodel = \"ggx\"\nmetallic = 1\ncolor = [1, 1, 1]\nroughness = 0\n"
             "reflection = \"sky\"\n"));
    const scene::SceneAt now = scene::at(scene, scene.timeline.values(1));
    const Picture picture = draw(*context, scene);
    const scene::Rays rays = scene::rays(now, 96, 96);
    int hits = 0, sky = 0;
    for (std::size_t pixel = 0; pixel < 96 * 96; ++pixel) {
        const double u = 2 * (double(pixel % 96) + 0.5) / 96 - 1;
        const double v = 1 - 2 * (double(pixel / 96) + 0.5) / 96;
        const glm::dvec3 eye = rays.origin - rays.axis;
        const glm::dvec3 d = glm::normalize(rays.axis + u * rays.right + v * rays.up);
        const double b = glm::dot(eye, d), c = glm::dot(eye, eye) - 1;
        if (b * b - c < 0) {
            expect_near(color(picture, pixel), looked_up(map, d), pixel);
            ++sky;
            continue;
        }
        const glm::dvec3 n = eye + (-b - std::sqrt(b * b - c)) * d;
        if (!is_hit(picture, pixel) || glm::dot(n, -d) < 0.2) continue;
        ++hits;
        // A white metal at its smoothest gives back all, but for the light lost in its furrows.
        const glm::dvec3 expected = looked_up(map, glm::reflect(d, n));
        const glm::dvec3 found = color(picture, pixel);
        for (int k = 0; k < 3; ++k) {
            ASSERT_NEAR(found[k], expected[k], 0.03 + 0.04 * expected[k]) << pixel;
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(sky, 1000);
}

TEST_P(Mirror, RotationAndIntensityAreOfTheMap) {
    const Picture turned = draw(*context, scene_of(ball("rotation = 90\nintensity = 0.5\n")));
    const scene::Scene plain = scene_of(ball(""));
    const scene::Rays rays = scene::rays(scene::at(plain, plain.timeline.values(1)), 96, 96);
    for (std::size_t pixel = 0; pixel < 96 * 96; pixel += 7) {
        if (is_hit(turned, pixel)) continue;
        const double u = 2 * (double(pixel % 96) + 0.5) / 96 - 1;
        const double v = 1 - 2 * (double(pixel / 96) + 0.5) / 96;
        const glm::dvec3 d = glm::normalize(rays.axis + u * rays.right + v * rays.up);
        // Surroundings turned by a quarter: what was along x is along y.
        expect_near(color(turned, pixel), 0.5 * looked_up(map, {d.y, -d.x, d.z}), pixel);
    }
}

TEST_P(Mirror, AMapThatIsNoneIsAnError) {
    const scene::Scene text =
        scene_of("[surface]\nformula = \"x\"\nbounds = { sphere = 1 }\n[environment]\n"
                 "map = \"" ISOMOTION_SOURCE_DIR "/README.md\"\n");
    EXPECT_THROW(draw(*context, text), std::exception);
    try {
        draw(*context, text);
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("README.md"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace isomotion::render
