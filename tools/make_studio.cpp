// Writes media/studio.exr: the light of a small photographic studio, as a latitude-longitude map.
//
//   cmake --build build/release --target make_studio && build/release/tools/make_studio FILE.exr
//
// A warm floor, a bluish ceiling and three soft boxes up to 18 times as bright as white paper.
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>

#include <glm/glm.hpp>

#include "base/file.h"
#include "image/encode.h"

namespace {

using glm::dvec3;
constexpr int height = 128, width = 2 * height;

dvec3 direction(double azimuth, double elevation) {
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

// A lit rectangle that faces the middle of the room from distance 1, upright.
struct SoftBox {
    double azimuth, elevation; // of its middle, degrees
    double across, up;         // half its size
    dvec3 light;
};

// The mean of the map is below 1: where a mirror's pixel shows all of the room, it is not white.
constexpr SoftBox boxes[] = {
    {48, 42, 0.50, 0.36, {7.2, 6.6, 5.9}},  // key: large, high, slightly warm
    {-62, 18, 0.17, 0.80, {2.6, 3.0, 3.6}}, // fill: a tall cool strip
    {168, 34, 0.75, 0.15, {3.8, 3.7, 3.5}}, // rim: a wide low bar behind
};

// 1 inside |x| < size, 0 outside, with an edge of finite width.
double window(double x, double size) {
    constexpr double edge = 0.06;
    return 1 - glm::smoothstep(size - edge, size + edge, std::abs(x));
}

double coverage(const SoftBox& box, dvec3 d) {
    const dvec3 middle = direction(glm::radians(box.azimuth), glm::radians(box.elevation));
    const double before = glm::dot(d, middle);
    if (before <= 0) return 0;
    const dvec3 across = glm::normalize(glm::cross(dvec3(0, 0, 1), middle));
    return window(glm::dot(d, across) / before, box.across) *
           window(glm::dot(d, glm::cross(middle, across)) / before, box.up);
}

dvec3 light(dvec3 d) {
    const dvec3 floor(0.34, 0.25, 0.17), wall(0.42, 0.40, 0.39), ceiling(0.22, 0.30, 0.46);
    dvec3 sum = glm::mix(wall, d.z < 0 ? floor : ceiling, glm::smoothstep(0.0, 1.0, std::abs(d.z)));
    for (const SoftBox& box : boxes) sum = glm::mix(sum, box.light, coverage(box, d));
    return sum;
}

// The mean over a texel.
dvec3 texel(int column, int row) {
    constexpr int samples = 4;
    dvec3 sum(0);
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            const double u = (column + (i + 0.5) / samples) / width;
            const double v = (row + (j + 0.5) / samples) / height;
            sum += light(direction((1 - 2 * u) * std::numbers::pi, (0.5 - v) * std::numbers::pi));
        }
    }
    return sum / double(samples * samples);
}

isomotion::image::Frame studio() {
    isomotion::image::Frame frame{width, height, {{"R", {}}, {"G", {}}, {"B", {}}}, {}};
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const dvec3 mean = texel(column, row);
            for (int c = 0; c < 3; ++c)
                frame.channels[std::size_t(c)].samples.push_back(float(mean[c]));
        }
    }
    return frame;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: make_studio FILE.exr\n", stderr);
        return 2;
    }
    try {
        isomotion::base::write_whole(
            arguments[1],
            isomotion::image::encode(studio(), isomotion::image::format_of(arguments[1])));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
