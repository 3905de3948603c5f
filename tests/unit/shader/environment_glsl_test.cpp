// shaders/effects/environment.glsl and the skies, against double on the CPU, on every back end.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <optional>
#include <random>
#include <span>

#include <glm/glm.hpp>
#include <gmock/gmock.h>

#include "gpu/buffer.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

constexpr double pi = std::numbers::pi;

struct Map {
    int width, height;
    std::vector<glm::vec4> texels;

    Map(int w, int h)
        : width(w)
        , height(h)
        , texels(std::size_t(w * h)) {}
    glm::vec4& at(int column, int row) { return texels[std::size_t(row * width + column)]; }
    glm::dvec3 at(int column, int row) const {
        return glm::vec3(texels[std::size_t(row * width + column)]);
    }
    gpu::Texture on_gpu() const {
        std::vector<float> floats(4 * texels.size());
        std::memcpy(floats.data(), texels.data(), 4 * floats.size());
        return {gpu::Format::rgba32f, width, height, floats};
    }
};

struct Placed {
    glm::vec3 ahead{1, 0, 0}, left{0, 1, 0}, top{0, 0, 1};
    float intensity = 1;
};

std::mt19937 seeded() {
    const char* given = std::getenv("ISOMOTION_SEED");
    const unsigned seed = given ? unsigned(std::strtoul(given, nullptr, 10)) : 20261u;
    std::printf("seed %u (ISOMOTION_SEED)\n", seed);
    return std::mt19937(seed);
}

float number(std::mt19937& engine) { return float(engine() >> 8) * 0x1p-24f; }

glm::vec3 random_direction(std::mt19937& engine) {
    for (;;) {
        const glm::vec3 d(2 * number(engine) - 1, 2 * number(engine) - 1, 2 * number(engine) - 1);
        if (glm::dot(d, d) > 0.01f && glm::dot(d, d) < 1) return glm::normalize(d);
    }
}

Map random_map(std::mt19937& engine, int width) {
    Map map(width, width / 2);
    for (glm::vec4& texel : map.texels)
        texel = {number(engine), 20 * number(engine), number(engine), 1};
    return map;
}

// The direction to (column, row) of a map, halves between texels.
glm::vec3 towards(const Map& map, double column, double row) {
    const double azimuth = pi - 2 * pi * (column + 0.5) / map.width;
    const double down = pi * (row + 0.5) / map.height;
    return glm::dvec3(std::sin(down) * std::cos(azimuth), std::sin(down) * std::sin(azimuth),
                      std::cos(down));
}

// Where a direction is, in texels: (0, 0) is the middle of the first.
glm::dvec2 place(const Map& map, const glm::dvec3& d) {
    return {(0.5 - std::atan2(d.y, d.x) / (2 * pi)) * map.width - 0.5,
            std::atan2(std::hypot(d.x, d.y), d.z) / pi * map.height - 0.5};
}

glm::dvec3 filtered(const Map& map, const glm::dvec3& d) {
    const glm::dvec2 at = place(map, d), corner = glm::floor(at), part = at - corner;
    const int left = (int(corner.x) + map.width) % map.width, right = (left + 1) % map.width;
    const int above = std::max(int(corner.y), 0);
    const int below = std::min(int(corner.y) + 1, map.height - 1);
    return glm::mix(glm::mix(map.at(left, above), map.at(right, above), part.x),
                    glm::mix(map.at(left, below), map.at(right, below), part.x), part.y);
}

glm::dvec3 in_map(const Placed& placed, const glm::vec3& d) {
    return {glm::dot(glm::dvec3(placed.ahead), glm::dvec3(d)),
            glm::dot(glm::dvec3(placed.left), glm::dvec3(d)),
            glm::dot(glm::dvec3(placed.top), glm::dvec3(d))};
}

std::string probe_shader(std::optional<Feature> sky) {
    ShaderText text;
    text.define(Feature::lights, 1);
    text.file("shade/shading.glsl");
    for (const auto& file : kernel_files({"atan"})) text.file(file);
    if (sky) text.define(*sky);
    text.file("effects/environment.glsl");
    text.file("effects/sky.glsl");
    text.generated("a direction a pixel", R"(
uniform sampler2D directions;
layout(location = 0) out vec4 color;

void main() {
    color = sky(texelFetch(directions, ivec2(gl_FragCoord.xy), 0).xyz);
}
)");
    return text.text();
}

std::vector<glm::vec4> draw(const gpu::Program& program, const std::vector<glm::vec3>& directions) {
    constexpr int width = 64;
    const int height = (int(directions.size()) + width - 1) / width;
    std::vector<float> given(std::size_t(4 * width * height));
    for (std::size_t k = 0; k < directions.size(); ++k)
        std::memcpy(&given[4 * k], &directions[k], sizeof(glm::vec3));
    const gpu::Texture texture(gpu::Format::rgba32f, width, height, given);
    const gpu::Target target(width, height);
    texture.bind(1);
    program.bind_sampler("directions", 1);
    target.bind();
    program.use();
    gpu::Fullscreen().draw();
    const std::vector<float> pixels = target.read(0, 0, 0, width, height);
    std::vector<glm::vec4> colors(directions.size());
    std::memcpy(colors.data(), pixels.data(), colors.size() * sizeof(glm::vec4));
    return colors;
}

std::vector<glm::vec4> look(const Map& map, const std::vector<glm::vec3>& directions,
                            const Placed& placed = {}) {
    const gpu::Program program(gpu::fullscreen_vertex, probe_shader(Feature::sky_environment),
                               "environment");
    const gpu::Texture texture = map.on_gpu();
    texture.bind(0);
    program.bind_sampler("environment_map", 0);
    program.set("environment_ahead", placed.ahead);
    program.set("environment_left", placed.left);
    program.set("environment_top", placed.top);
    program.set("environment_intensity", placed.intensity);
    return draw(program, directions);
}

// The largest difference from the reference, of values up to 20.
void expect_filtered(const Map& map, const std::vector<glm::vec3>& directions, const Placed& placed,
                     double tolerance) {
    const auto seen = look(map, directions, placed);
    double worst = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const glm::dvec3 expected =
            double(placed.intensity) * filtered(map, in_map(placed, directions[k]));
        const glm::dvec3 difference = glm::abs(glm::dvec3(glm::vec3(seen[k])) - expected);
        worst = std::max({worst, difference.x, difference.y, difference.z});
        EXPECT_EQ(seen[k].a, 1.0f);
    }
    EXPECT_LT(worst, tolerance);
}

class EnvironmentGlsl : public gpu::EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(EnvironmentGlsl);

TEST_P(EnvironmentGlsl, AxesOfTheWorld) {
    Map map(8, 4); // columns and rows that touch an axis
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 8; ++column) map.at(column, row) = {column, row, 0, 1};
    const auto seen = look(map, {{1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    EXPECT_FLOAT_EQ(seen[0].r, 3.5f); // ahead: the middle
    EXPECT_FLOAT_EQ(seen[0].g, 1.5f);
    EXPECT_FLOAT_EQ(seen[1].r, 1.5f); // left: the left quarter, so that the world is not mirrored
    EXPECT_FLOAT_EQ(seen[2].r, 5.5f);
    EXPECT_FLOAT_EQ(seen[3].g, 0.0f);
    EXPECT_FLOAT_EQ(seen[4].g, 3.0f);
}

TEST_P(EnvironmentGlsl, TexelsInTheirMiddles) {
    auto engine = seeded();
    const Map map = random_map(engine, 64);
    std::vector<glm::vec3> directions;
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column)
            directions.push_back(towards(map, column, row));
    const auto seen = look(map, directions);
    for (std::size_t k = 0; k < seen.size(); ++k)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[k][c], map.texels[k][c], 20 * 3e-5) << k;
}

TEST_P(EnvironmentGlsl, MeansHalfwayAndRoundTheBack) {
    auto engine = seeded();
    const Map map = random_map(engine, 64);
    std::vector<glm::vec3> directions;
    std::vector<glm::dvec3> means;
    for (int row = 0; row < map.height; ++row) {
        for (int column = 0; column < map.width; ++column) { // the last is at the back
            directions.push_back(towards(map, column + 0.5, row));
            means.push_back((map.at(column, row) + map.at((column + 1) % map.width, row)) / 2.0);
            if (row + 1 == map.height) continue;
            directions.push_back(towards(map, column, row + 0.5));
            means.push_back((map.at(column, row) + map.at(column, row + 1)) / 2.0);
        }
    }
    const auto seen = look(map, directions);
    for (std::size_t k = 0; k < seen.size(); ++k)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[k][c], means[k][c], 20 * 3e-5) << k;
}

TEST_P(EnvironmentGlsl, NoSeamAtTheBack) {
    auto engine = seeded();
    const Map map = random_map(engine, 64);
    std::vector<glm::vec3> directions;
    for (const float y : {0.0f, -0.0f, 1e-38f, -1e-38f, 1e-20f, -1e-20f, 1e-7f, -1e-7f})
        for (const float z : {0.0f, 0.3f, -0.9f})
            directions.push_back({-std::sqrt(1 - z * z), y, z});
    expect_filtered(map, directions, {}, 20 * 2e-5);
}

// Any longitude will do at a pole; beside it, all of them count.
TEST_P(EnvironmentGlsl, Poles) {
    auto engine = seeded();
    const Map map = random_map(engine, 64);
    std::vector<glm::vec3> beside;
    for (const float z : {1.0f, -1.0f})
        for (const float far : {1e-30f, 1e-10f, 1e-6f, 1e-3f, 0.02f})
            for (int k = 0; k < 12; ++k) {
                const double azimuth = 0.1 + k * pi / 6;
                beside.push_back({far * std::cos(azimuth), far * std::sin(azimuth),
                                  z * std::sqrt(1 - far * far)});
            }
    expect_filtered(map, beside, {}, 20 * 2e-5);

    const auto seen = look(map, {{0, 0, 1}, {0, 0, -1}});
    EXPECT_EQ(glm::vec3(seen[0]), glm::vec3(filtered(map, {1e-300, 0, 1})));
    EXPECT_EQ(glm::vec3(seen[1]), glm::vec3(filtered(map, {1e-300, 0, -1})));
}

TEST_P(EnvironmentGlsl, RandomDirectionsAsTheReferenceHasThem) {
    auto engine = seeded();
    const Map map = random_map(engine, 256);
    for (int turn = 0; turn < 4; ++turn) {
        std::vector<glm::vec3> directions;
        for (int k = 0; k < 2000; ++k) directions.push_back(random_direction(engine));
        Placed placed;
        if (turn > 0) {
            placed.ahead = random_direction(engine);
            placed.left = glm::normalize(glm::cross(random_direction(engine), placed.ahead));
            placed.top = glm::cross(placed.ahead, placed.left);
            placed.intensity = 0.25f * float(turn);
        }
        // Up to 20 a texel, and beside a pole a degree crosses many of them.
        expect_filtered(map, directions, placed, 20 * 256 * 1e-5);
    }
}

TEST_P(EnvironmentGlsl, AQuarterTurnMovesTheMapByAQuarterOfItsWidth) {
    auto engine = seeded();
    const Map map = random_map(engine, 64);
    Map moved = map; // counter-clockwise from above: to the left
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column)
            moved.at(column, row) = glm::vec4(map.at((column + 16) % 64, row), 1);
    std::vector<glm::vec3> directions;
    for (int k = 0; k < 1000; ++k) directions.push_back(random_direction(engine));
    const auto turned = look(map, directions, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, 1});
    const auto expected = look(moved, directions);
    for (std::size_t k = 0; k < turned.size(); ++k)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(turned[k][c], expected[k][c], 20 * 64 * 1e-6) << k;
}

// How far off a place is, read from maps whose texels say where they are.
TEST_P(EnvironmentGlsl, PlacesAreAccurateOnALargeMap) {
    auto engine = seeded();
    Map map(2048, 1024);
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column)
            map.at(column, row) = {column, row, 0, 1};
    std::vector<glm::vec3> directions;
    while (directions.size() < 20'000) {
        const glm::vec3 d = random_direction(engine);
        const glm::dvec2 at = place(map, d);
        const bool inside = at.x > 0 && at.x < map.width - 1 && at.y > 0 && at.y < map.height - 1;
        if (inside) directions.push_back(d);
    }
    const auto seen = look(map, directions);
    glm::dvec2 worst(0);
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const glm::dvec2 at = place(map, directions[k]);
        worst = glm::max(worst, glm::abs(glm::dvec2(seen[k].r, seen[k].g) - at));
    }
    std::printf("off by %.2g and %.2g of a texel\n", worst.x, worst.y);
    EXPECT_LT(worst.x, 3e-4);
    EXPECT_LT(worst.y, 3e-4);
}

// What Shading holds for a sky: material, background, a light and its colour, to_world, depth.
std::array<glm::vec4, 9> shading(const glm::mat4& to_world) {
    return {glm::vec4(1), {0.25, 0.5, 0.75, 0.125},
            {0, 0, 1, 0}, glm::vec4(1),
            to_world[0],  to_world[1],
            to_world[2],  to_world[3],
            glm::vec4(0)};
}

std::vector<glm::vec4> look_at_sky(std::optional<Feature> sky, const glm::mat4& to_world,
                                   const std::vector<glm::vec3>& directions) {
    const gpu::Program program(gpu::fullscreen_vertex, probe_shader(sky), "sky");
    const auto values = shading(to_world);
    gpu::UniformBuffer block(sizeof(values));
    block.update(std::as_bytes(std::span(values)));
    block.bind(0);
    program.bind_block("Shading", 0);
    program.set("sky_top", glm::vec3(4, 2, 1));
    program.set("sky_bottom", glm::vec3(0, 1, 1));
    return draw(program, directions);
}

TEST_P(EnvironmentGlsl, AFlatSkyIsTheBackgroundWithItsCoverage) {
    for (const auto& color : look_at_sky({}, glm::mat4(1), {{1, 0, 0}, {0, 0, -1}}))
        EXPECT_EQ(color, glm::vec4(0.25, 0.5, 0.75, 0.125));
}

TEST_P(EnvironmentGlsl, AGradientFollowsTheWorldHoweverTheSurfaceLies) {
    // Formula coordinates turned by 90 degrees about x, larger, elsewhere: their y is the world's
    // z.
    const glm::mat4 lying(3, 0, 0, 0, 0, 0, 3, 0, 0, -3, 0, 0, 7, 8, 9, 1);
    const std::vector<glm::vec3> up{{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}};
    const glm::vec4 expected[] = {
        {4, 2, 1, 1}, {0, 1, 1, 1}, {2, 1.5, 1, 1}, {2, 1.5, 1, 1}, {3.6, 1.9, 1, 1}};
    const auto seen = look_at_sky(Feature::sky_gradient, lying, up);
    for (std::size_t k = 0; k < up.size(); ++k)
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(seen[k][c], expected[k][c], 1e-6) << k;
}

} // namespace
} // namespace isomotion::shader
