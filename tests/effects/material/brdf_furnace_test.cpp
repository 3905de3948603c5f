// The white furnace: under light from everywhere, a material sends back what came, or a little
// less.
#include "brdf_on_gpu.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>

#include "thorough.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::effects {
namespace {

using gpu::EveryBackend;
using std::numbers::pi;

const glm::dvec3 up(0, 0, 1);

// How a quadrature's directions to the light lie: half of them spread like the cosine, half about
// the highlight of a viewer (visible normals of GGX, Dupuy & Benyoub 2023). `weight` is
// 1 / (number * density) of both together, so that a sum over all directions is an integral.
class Hemisphere {
public:
    Hemisphere(const glm::dvec3& to_viewer, double alpha)
        : viewer_(to_viewer)
        , alpha_(alpha) {
        // Hammersley's points: even along an edge too, such as the highlight's at the horizon.
        constexpr std::uint32_t number = 1u << 15;
        for (std::uint32_t k = 0; k < number; ++k) {
            const double u = (k + 0.5) / number, w = (reversed_bits(k) + 0.5) / number;
            add(spread(u, w), number);
            add(mirrored(u, w), number);
        }
    }

    std::vector<Geometry> places;
    std::vector<double> weights;

private:
    static std::uint32_t reversed_bits(std::uint32_t k) {
        std::uint32_t reversed = 0;
        for (int bit = 0; bit < 15; ++bit) reversed |= (k >> bit & 1u) << (14 - bit);
        return reversed;
    }

    static glm::dvec3 spread(double u, double w) {
        const double r = std::sqrt(w);
        return {r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), std::sqrt(1 - w)};
    }

    glm::dvec3 mirrored(double u, double w) const {
        const glm::dvec3 squeeze(alpha_, alpha_, 1);
        const glm::dvec3 v = glm::normalize(viewer_ * squeeze);
        const double z = (1 - w) * (1 + v.z) - v.z;
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        const glm::dvec3 cap(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), z);
        const glm::dvec3 h = glm::normalize((cap + v) * squeeze);
        return 2 * glm::dot(viewer_, h) * h - viewer_;
    }

    double density(const glm::dvec3& l) const {
        const glm::dvec3 h = glm::normalize(viewer_ + l);
        const double a2 = alpha_ * alpha_;
        const double slope = h.z * h.z * a2 + h.x * h.x + h.y * h.y;
        const double distribution = a2 / (pi * slope * slope);
        // D G1 (v.h) / (n.v) of the half vectors, 1 / (4 v.h) of them to directions.
        const double v = viewer_.z;
        const double highlight = distribution / (2 * (v + std::sqrt(v * v * (1 - a2) + a2)));
        return l.z / pi + highlight;
    }

    void add(const glm::dvec3& l, double number) {
        if (!(l.z > 0)) return;
        places.push_back({up, viewer_, l});
        weights.push_back(1 / (number * density(l)));
    }

    glm::dvec3 viewer_;
    double alpha_;
};

// The light sent to the viewer under light of colour 1 from everywhere.
double furnace(const BrdfOnGpu& reflected, const Gloss& gloss, double degrees, double alpha) {
    const double angle = glm::radians(degrees);
    const Hemisphere lights({std::sin(angle), 0, std::cos(angle)}, alpha);
    const auto results = reflected(gloss, lights.places);
    double sum = 0;
    for (std::size_t k = 0; k < results.size(); ++k) sum += lights.weights[k] * results[k].x;
    return sum / pi;
}

// Bounds below 1 are what the shader's fitted functions leave, and a little room.
struct Extremes {
    double least = 1e9, most = 0;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

const double angles[] = {0, 15, 30, 45, 60, 70, 75, 80, 85};
const float roughnesses[] = {0.05f, 0.07f, 0.1f, 0.15f, 0.2f, 0.3f, 0.4f,
                             0.5f,  0.6f,  0.7f, 0.8f,  0.9f, 1.0f};

// The ends and every third between them, or all.
template<typename T, std::size_t n> std::vector<T> some_of(const T (&values)[n]) {
    std::vector<T> some;
    for (std::size_t k = 0; k < n; ++k)
        if (is_thorough() || k % 3 == 0 || k + 1 == n) some.push_back(values[k]);
    return some;
}

Extremes ggx_furnace(const glm::vec3& albedo, float metallic, float specular) {
    const BrdfOnGpu reflected("ggx");
    Extremes all;
    for (const float roughness : some_of(roughnesses)) {
        for (const double degrees : some_of(angles)) {
            all.add(furnace(reflected, {albedo, {roughness, metallic, specular, 0}}, degrees,
                            double(roughness) * double(roughness)));
        }
    }
    std::printf("albedo %g, metallic %g, specular %g: %.4f to %.4f\n", double(albedo.x),
                double(metallic), double(specular), all.least, all.most);
    return all;
}

class BrdfFurnace : public EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(BrdfFurnace);

// The quadrature itself, where the integral is known.
TEST_P(BrdfFurnace, AMattWhiteSurfaceSendsBackWhatCame) {
    const BrdfOnGpu reflected("lambert");
    for (const double alpha : {0.0025, 0.1, 1.0}) {
        for (const double degrees : angles) {
            EXPECT_NEAR(furnace(reflected, {glm::vec3(1), glm::vec4(0)}, degrees, alpha), 1, 5e-4);
        }
    }
}

// The functions fitted to them are as near as effects/material.glsl says.
TEST_P(BrdfFurnace, WhatFacetsLoseAtFirstAndTheirRim) {
    const std::string once = ", normal, to_viewer, to_light, dot(normal, to_viewer), dot(normal, "
                             "to_light)) * dot(normal, to_light)";
    const BrdfOnGpu white("ggx", "single_scattering(Specular(vec3(1), vec3(1), vec3(0))" + once);
    const BrdfOnGpu rim("ggx", "single_scattering(Specular(vec3(0), vec3(1), vec3(0))" + once);
    const BrdfOnGpu fitted("ggx", "vec3(lost_and_rim(dot(normal, to_viewer)), 0.0)");
    for (const float roughness : roughnesses) {
        const double alpha = double(roughness) * double(roughness);
        const Gloss gloss{glm::vec3(1), {roughness, 1, 0, 0}};
        for (const double degrees : angles) {
            const float angle = glm::radians(float(degrees));
            const glm::vec3 v(std::sin(angle), 0, std::cos(angle));
            const glm::dvec3 found = fitted(gloss, {{up, v, v}}).front();
            const double lost_error = found.x - (1 - furnace(white, gloss, degrees, alpha));
            const double rim_error = found.y - furnace(rim, gloss, degrees, alpha);
            EXPECT_GE(lost_error, -0.017) << roughness << ' ' << degrees;
            EXPECT_LE(lost_error, 0.0025) << roughness << ' ' << degrees;
            EXPECT_GE(rim_error, -0.003) << roughness << ' ' << degrees;
            EXPECT_LE(rim_error, 0.021) << roughness << ' ' << degrees;
        }
    }
}

TEST_P(BrdfFurnace, AWhiteMetalKeepsNothingAndMakesNothing) {
    const Extremes all = ggx_furnace(glm::vec3(1), 1, 0);
    EXPECT_LE(all.most, 1 + 1e-3);
    EXPECT_GE(all.least, 0.97);
}

TEST_P(BrdfFurnace, HighlightAndMattPartTogetherMakeNothing) {
    for (const float specular : {0.02f, 0.04f, 0.3f, 1.0f}) {
        const Extremes all = ggx_furnace(glm::vec3(1), 0, specular);
        EXPECT_LE(all.most, 1 + 1e-3) << specular;
        EXPECT_GE(all.least, 0.97) << specular;
    }
    const Extremes half = ggx_furnace(glm::vec3(1), 0.5f, 0.04f);
    EXPECT_LE(half.most, 1 + 1e-3);
    EXPECT_GE(half.least, 0.97);
}

// A black dielectric has its highlight only; a black metal has nothing.
TEST_P(BrdfFurnace, BlackIsTheHighlightAlone) {
    const Extremes dielectric = ggx_furnace(glm::vec3(0), 0, 0.04f);
    EXPECT_GT(dielectric.least, 0.01);
    EXPECT_LT(dielectric.most, 0.7);
    EXPECT_EQ(ggx_furnace(glm::vec3(0), 1, 0.04f).most, 0);
}

TEST_P(BrdfFurnace, BlinnPhongMakesNothing) {
    const BrdfOnGpu reflected("blinn-phong");
    for (const float shininess : {0.0f, 1.0f, 5.0f, 20.0f, 100.0f, 1000.0f, 10'000.0f}) {
        const double alpha = std::sqrt(2 / (double(shininess) + 2)); // as wide a highlight
        for (const float specular : {0.2f, 1.0f}) {
            for (const double degrees : angles) {
                const double sum =
                    furnace(reflected, {glm::vec3(1), {shininess, specular, 0, 0}}, degrees, alpha);
                EXPECT_LE(sum, 1 + 1e-3) << shininess << ' ' << specular << ' ' << degrees;
                if (degrees == 0) {
                    EXPECT_GE(sum, 0.998) << shininess << ' ' << specular;
                }
            }
        }
    }
}

} // namespace
} // namespace isomotion::effects
