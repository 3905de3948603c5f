#include "image/environment_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/glm.hpp>

namespace isomotion::image {
namespace {

using std::numbers::pi;

constexpr int level_count = 8, narrowest_level = 32;

// A map as three numbers a texel, and its halves.
struct Layer {
    int width = 0, height = 0;
    std::vector<glm::vec3> texels;

    const glm::vec3& at(int column, int row) const {
        return texels[std::size_t(row) * std::size_t(width) + std::size_t(column)];
    }
};

Layer layer_of(const EnvironmentMap& map) {
    Layer layer{map.width, map.height, {}};
    for (std::size_t k = 0; k + 3 < map.texels.size(); k += 4)
        layer.texels.emplace_back(map.texels[k], map.texels[k + 1], map.texels[k + 2]);
    return layer;
}

Layer half_of(const Layer& layer) {
    Layer half{layer.width / 2, layer.height / 2, {}};
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            half.texels.push_back(0.25f *
                                  (layer.at(2 * x, 2 * y) + layer.at(2 * x + 1, 2 * y) +
                                   layer.at(2 * x, 2 * y + 1) + layer.at(2 * x + 1, 2 * y + 1)));
        }
    }
    return half;
}

std::vector<Layer> pyramid_of(const EnvironmentMap& map) {
    std::vector<Layer> pyramid{layer_of(map)};
    while (pyramid.back().width >= 8 && pyramid.back().height >= 4)
        pyramid.push_back(half_of(pyramid.back()));
    return pyramid;
}

// Reads a layer as shaders/effects/environment.glsl does; `u` and `v` are from 0 to 1.
glm::vec3 filtered(const Layer& layer, float u, float v) {
    const float x = u * float(layer.width) - 0.5f, y = v * float(layer.height) - 0.5f;
    const float left = std::floor(x), above = std::floor(y);
    const int column = (int(left) + layer.width) % layer.width;
    const int next = column + 1 < layer.width ? column + 1 : 0;
    const int row = std::clamp(int(above), 0, layer.height - 1);
    const int below = std::clamp(int(above) + 1, 0, layer.height - 1);
    return glm::mix(glm::mix(layer.at(column, row), layer.at(next, row), x - left),
                    glm::mix(layer.at(column, below), layer.at(next, below), x - left), y - above);
}

// A direction of the lobe about z, its weight, and the solid angle that it stands for.
struct Sample {
    glm::vec3 direction;
    float weight, solid_angle;
};

float reversed_bits(std::uint32_t k) {
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < 32; ++bit) reversed |= (k >> bit & 1u) << (31 - bit);
    return float(double(reversed) * 0x1p-32);
}

std::vector<Sample> lobe(double alpha, std::uint32_t samples) {
    std::vector<Sample> all;
    for (std::uint32_t k = 0; k < samples; ++k) {
        const double part = (k + 0.5) / samples, angle = 2 * pi * reversed_bits(k);
        const double a2 = alpha * alpha;
        const double cosine2 = (1 - part) / (1 + (a2 - 1) * part);
        const double cosine = std::sqrt(cosine2), sine = std::sqrt(1 - cosine2);
        // Mirrored at the facet: twice the angle.
        const double z = 2 * cosine2 - 1, across = 2 * sine * cosine;
        if (!(z > 0)) continue;
        const double slope = 1 + (a2 - 1) * cosine2;
        const double density = a2 / (4 * pi * slope * slope); // D / 4, where view and normal agree
        all.push_back({glm::vec3(across * std::cos(angle), across * std::sin(angle), z), float(z),
                       float(1 / (samples * density))});
    }
    return all;
}

class Blur {
public:
    Blur(const std::vector<Layer>& pyramid, double alpha, std::uint32_t samples)
        : pyramid_(pyramid)
        , lobe_(lobe(alpha, samples)) {
        for (const Sample& sample : lobe_) weight_ += sample.weight;
    }

    glm::vec3 about(const glm::vec3& normal) const {
        const glm::vec3 axis = std::abs(normal.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
        const glm::vec3 u = glm::normalize(glm::cross(axis, normal)), v = glm::cross(normal, u);
        glm::vec3 sum(0);
        for (const Sample& sample : lobe_) {
            const glm::vec3& d = sample.direction;
            sum += sample.weight * light(d.x * u + d.y * v + d.z * normal, sample.solid_angle);
        }
        return sum / weight_;
    }

private:
    // The mean of about this solid angle.
    glm::vec3 light(const glm::vec3& d, float solid_angle) const {
        const float sine = std::max(std::hypot(d.x, d.y), 1e-3f);
        const Layer& finest = pyramid_.front();
        const float texel =
            float(2 * pi * pi) * sine / (float(finest.width) * float(finest.height));
        const float level =
            std::clamp(0.5f * std::log2(solid_angle / texel), 0.0f, float(pyramid_.size() - 1));
        const auto lower = std::min(std::size_t(level), pyramid_.size() - 1);
        const auto upper = std::min(lower + 1, pyramid_.size() - 1);
        const float u = 0.5f - std::atan2(d.y, d.x) / float(2 * pi);
        const float v = std::atan2(std::hypot(d.x, d.y), d.z) / float(pi);
        return glm::mix(filtered(pyramid_[lower], u, v), filtered(pyramid_[upper], u, v),
                        level - float(lower));
    }

    const std::vector<Layer>& pyramid_;
    std::vector<Sample> lobe_;
    float weight_ = 0;
};

// Towards the middle of a texel.
glm::vec3 direction_of(int column, int row, int width) {
    const double azimuth = pi - 2 * pi * (column + 0.5) / width;
    const double down = pi * (row + 0.5) / (width / 2); // NOLINT(bugprone-integer-division): even
    return {std::sin(down) * std::cos(azimuth), std::sin(down) * std::sin(azimuth), std::cos(down)};
}

} // namespace

void EnvironmentReduction::begin(int width, int height) {
    read_width_ = width;
    while (width / block_ > widest_) block_ *= 2;
    width_ = std::max(width / block_, 1);
    height_ = std::max(height / block_, 1);
    sums_.assign(3 * std::size_t(width_) * std::size_t(height_), 0.0);
}

void EnvironmentReduction::rows(int first, std::span<const float> texels) {
    const auto across = std::size_t(read_width_);
    for (std::size_t k = 0; 4 * k < texels.size(); ++k) {
        const int x = int(k % across) / block_, y = (first + int(k / across)) / block_;
        if (x >= width_ || y >= height_) continue; // a rest less than a block
        double* sum = &sums_[3 * (std::size_t(y) * std::size_t(width_) + std::size_t(x))];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += texels[4 * k + c];
    }
}

EnvironmentMap EnvironmentReduction::map() const {
    EnvironmentMap map{width_, height_, {}, 0};
    map.texels.reserve(4 * sums_.size() / 3);
    for (std::size_t k = 0; k < sums_.size(); k += 3) {
        for (std::size_t c = 0; c < 3; ++c)
            map.texels.push_back(float(sums_[k + c] / (double(block_) * block_)));
        map.texels.push_back(1);
    }
    return map;
}

EnvironmentMap environment_levels(const EnvironmentMap& map, int widest) {
    const std::vector<Layer> pyramid = pyramid_of(map);
    EnvironmentMap levels{widest, 0, {}, 0};
    int width = widest;
    for (int k = 0; k < level_count; ++k) {
        // Small maps afford more samples, and wide lobes need them.
        const std::uint32_t samples = width > 64 ? 64 : 512;
        const Blur blur(pyramid, std::ldexp(1.0, k + 1 - level_count), samples);
        for (int row = 0; row < width / 2; ++row) {
            for (int column = 0; column < width; ++column) {
                const glm::vec3 light = blur.about(direction_of(column, row, width));
                levels.texels.insert(levels.texels.end(), {light.x, light.y, light.z, 1.0f});
            }
            levels.texels.resize(levels.texels.size() + 4 * std::size_t(widest - width), 0.0f);
        }
        levels.height += width / 2;
        width = std::max(width / 2, narrowest_level);
    }
    return levels;
}

} // namespace isomotion::image
