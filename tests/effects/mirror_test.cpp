// Mirrors and what is around, where the closed form says.
#include <cmath>

#include <fmt/format.h>

#include "base/file.h"
#include "image/encode.h"
#include "image/environment.h"
#include "render/drawing.h"
#include "unit/base/places.h"

namespace isomotion::render {
namespace {

using base::TemporaryFolder;

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
    constexpr int side = 512; // narrow pixels
    scene::Scene scene = scene_of(
        ball("[material]\nmodel = \"ggx\"\nmetallic = 1\ncolor = [1, 1, 1]\nroughness = 0\n"
             "reflection = \"sky\"\n"));
    scene.output.width = scene.output.height = side;
    const scene::SceneAt now = scene::at_frame(scene, 1);
    const Picture picture = draw(*context, scene);
    const scene::Rays rays = scene::rays(now, side, side);
    int hits = 0, sky = 0;
    for (std::size_t pixel = 0; pixel < side * side; ++pixel) {
        const double u = 2 * (double(pixel % side) + 0.5) / side - 1;
        const double v = 1 - 2 * (double(pixel / side) + 0.5) / side;
        const glm::dvec3 eye = rays.origin - rays.axis;
        const glm::dvec3 d = glm::normalize(rays.axis + u * rays.right + v * rays.up);
        const double b = glm::dot(eye, d), c = glm::dot(eye, eye) - 1;
        if (b * b - c < 0) {
            expect_near(color(picture, pixel), looked_up(map, d), pixel);
            ++sky;
            continue;
        }
        const glm::dvec3 n = eye + (-b - std::sqrt(b * b - c)) * d;
        // Elsewhere a pixel sees so much of the map that it shows a mean of it.
        if (!is_hit(picture, pixel) || glm::dot(n, -d) < 0.6) continue;
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
    const scene::Rays rays = scene::rays(scene::at_frame(plain, 1), 96, 96);
    for (std::size_t pixel = 0; pixel < 96 * 96; pixel += 7) {
        if (is_hit(turned, pixel)) continue;
        const double u = 2 * (double(pixel % 96) + 0.5) / 96 - 1;
        const double v = 1 - 2 * (double(pixel / 96) + 0.5) / 96;
        const glm::dvec3 d = glm::normalize(rays.axis + u * rays.right + v * rays.up);
        // Surroundings turned by a quarter: what was along x is along y.
        expect_near(color(turned, pixel), 0.5 * looked_up(map, {d.y, -d.x, d.z}), pixel);
    }
}

// A map of 1 + z, of which a rough mirror shows 1 + s z (tests/unit/image has s).
class RoughMirror : public Drawing {
protected:
    static std::string map_file(const TemporaryFolder& folder) {
        constexpr int width = 256;
        image::Frame frame{width, width / 2, {}, {}};
        for (const char* name : {"R", "G", "B"}) {
            image::Channel channel{name, {}};
            for (int row = 0; row < width / 2; ++row) {
                const double z = std::cos(2 * M_PI * (row + 0.5) / width);
                channel.samples.insert(channel.samples.end(), width, float(1 + z));
            }
            frame.channels.push_back(channel);
        }
        const auto file = folder / "map.exr";
        base::write_whole(file, image::encode(frame, image::Format::exr));
        return file.string();
    }
    static double share_of_slope(double alpha) {
        double sum = 0, weights = 0;
        for (int k = 0; k < 10'000; ++k) {
            const double part = (k + 0.5) / 10'000;
            const double z = 2 * (1 - part) / (1 + (alpha * alpha - 1) * part) - 1;
            if (z > 0) sum += z * z, weights += z;
        }
        return sum / weights;
    }
    TemporaryFolder folder_;
};
ISOMOTION_ON_EVERY_BACKEND(RoughMirror);

TEST_P(RoughMirror, ABallShowsTheMapAsBlurredAsItIsRough) {
    const std::string map = map_file(folder_);
    for (const double roughness : {0.3, 0.5, 0.8, 1.0}) {
        const scene::Scene scene = scene_of(fmt::format(
            "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = {{ sphere = 1.2 }}\n[camera]\n"
            "position = [8, 0, 0]\ntarget = [0, 0, 0]\nup = [0, 0, 1]\nfov = 20\n[[lights]]\n"
            "direction = [0, 0, 1]\ncolor = [0, 0, 0]\n[environment]\nmap = \"{}\"\n[material]\n"
            "model = \"ggx\"\nmetallic = 1\ncolor = [1, 1, 1]\nroughness = {}\n"
            "reflection = \"sky\"\n[output]\nsize = [65, 65]\n",
            map, roughness));
        const Picture picture = draw(*context, scene);
        const auto seen = [&](int row) {
            return double(picture.frame.channels[0].samples[std::size_t(row) * 65 + 32]);
        };
        // Straight ahead the map is 1. As far above as below, what the material takes is the same.
        EXPECT_NEAR(seen(32), 1, 0.06) << roughness;
        const double share = share_of_slope(roughness * roughness);
        for (const int rows : {4, 8, 12}) {
            const glm::dvec3 ray =
                glm::normalize(glm::dvec3(-1, 0, rows / 32.5 * std::tan(10 * M_PI / 180)));
            const double b = 8 * ray.x;
            const glm::dvec3 n = glm::dvec3(8, 0, 0) + (-b - std::sqrt(b * b - 63)) * ray;
            const double z = glm::reflect(ray, n).z;
            const double above = seen(32 - rows), below = seen(32 + rows);
            EXPECT_NEAR((above - below) / (above + below), share * z, 0.05)
                << roughness << ", " << rows << ": " << above << ", " << below;
        }
    }
}

// A chrome ball with ripples about as narrow as a pixel of a picture 64 pixels wide.
std::string rippled_ball(int side) {
    return fmt::format(
        "[surface]\nformula = \"x^2 + y^2 + z^2 - 1 - 0.01*sin(60*x)*sin(60*y)*sin(60*z)\"\n"
        "bounds = {{ sphere = 1.2 }}\n[camera]\nposition = [4, 0, 0]\ntarget = [0, 0, 0]\n"
        "up = [0, 0, 1]\nfov = 36\n[[lights]]\ndirection = [1, 0, 0.2]\ncolor = [1, 1, 1]\n"
        "[environment]\nmap = \"{}\"\n[material]\nmodel = \"ggx\"\nmetallic = 1\n"
        "color = [1, 1, 1]\nroughness = 0.1\nreflection = \"sky\"\n[output]\nsize = [{}, {}]\n",
        studio, side, side);
}

// Few pixels are far brighter than all around them.
TEST_P(RoughMirror, RipplesDoNotGlitter) {
    constexpr int side = 64;
    const Picture picture = draw(*context, scene_of(rippled_ball(side)));
    const auto& red = picture.frame.channels[0].samples;
    int alone = 0;
    for (int y = 1; y + 1 < side; ++y) {
        for (int x = 1; x + 1 < side; ++x) {
            float around = 0;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (dx != 0 || dy != 0)
                        around = std::max(around, red[std::size_t((y + dy) * side + x + dx)]);
                }
            }
            alone += red[std::size_t(y * side + x)] > 3 * std::max(around, 0.3f);
        }
    }
    // 30 where the normal's turn within a pixel is left out. More blur leaves fewer, and a picture
    // that is brighter than what many rays a pixel see.
    EXPECT_LE(alone, 14);
}

// Blur moves light and adds little: GGX's tails are wider than what a pixel sees.
TEST_P(RoughMirror, RipplesAreAboutAsBrightAsManyRaysSeeThem) {
    const auto mean = [&](int side) {
        const Picture picture = draw(*context, scene_of(rippled_ball(side)));
        double sum = 0;
        for (const float red : picture.frame.channels[0].samples) sum += double(red);
        return sum / side / side;
    };
    const double many = mean(512);
    EXPECT_NEAR(mean(64) / many, 1, 0.15);
}

} // namespace
} // namespace isomotion::render
