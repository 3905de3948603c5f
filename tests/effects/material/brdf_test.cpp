// What holds for every material, at its nastiest first, and each against its formula in double.
#include "brdf_on_gpu.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "unit/gpu/every_backend.h"

namespace isomotion::effects {
namespace {

using gpu::EveryBackend;
using std::numbers::pi;

struct Model {
    const char* file;
    std::vector<glm::vec4> glosses; // the ends of what they may be, beyond them, and between
};

const std::vector<Model>& models() {
    static const std::vector<Model> all = {
        {"lambert", {glm::vec4(0)}},
        {"blinn-phong",
         {{0, 0, 0, 0},
          {0, 1, 0, 0},
          {1, 0.5, 0, 0},
          {50, 0.2, 0, 0},
          {1e4, 1, 0, 0},
          {-3, 7, 0, 0}}},
        {"ggx",
         {{0, 0, 0, 0},
          {0, 1, 0, 0},
          {0, 0, 1, 0},
          {0.4, 0, 0.04, 0},
          {1, 1, 1, 0},
          {1, 0, 0.04, 0},
          {0.3, 0.5, 0.5, 0},
          {-1, 2, 3, 0},
          {7, -1, -1, 0}}},
    };
    return all;
}

const std::vector<glm::vec3> albedos = {
    glm::vec3(0), glm::vec3(1), {0.8f, 0.3f, 0}, glm::vec3(1e-30f)};

unsigned seed() {
    const char* given = std::getenv("ISOMOTION_SEED");
    return given ? unsigned(std::strtoul(given, nullptr, 10)) : 20261u;
}

class Directions {
public:
    explicit Directions(unsigned from)
        : random_(from) {}

    glm::vec3 anywhere() {
        const glm::vec3 d(normal_(random_), normal_(random_), normal_(random_));
        return glm::normalize(d);
    }
    glm::vec3 above(const glm::vec3& normal) {
        const glm::vec3 d = anywhere();
        return glm::dot(d, normal) < 0 ? -d : d;
    }

private:
    std::mt19937 random_;
    std::normal_distribution<float> normal_;
};

class Brdf : public EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(Brdf);

// Directions at the horizon, below it, opposite to each other, along the normal, and next to all of
// these.
std::vector<Geometry> nasty_places() {
    std::vector<float> cosines = {-1,     -0.5f, -1e-3f, -1e-7f, -1e-30f, -0.0f,      0, 1e-38f,
                                  1e-30f, 1e-7f, 1e-4f,  1e-3f,  0.5f,    0.9999999f, 1};
    std::vector<Geometry> places;
    for (const glm::vec3& n : {glm::vec3(0, 0, 1), glm::normalize(glm::vec3(1, -2, 3))}) {
        const glm::vec3 x = glm::normalize(glm::cross(n, glm::vec3(0.3f, 1, 0)));
        const auto direction = [&](float cosine, float side) {
            return cosine * n + side * std::sqrt(std::max(0.0f, 1 - cosine * cosine)) * x;
        };
        for (const float v : cosines) {
            for (const float l : cosines) {
                for (const float side : {-1.0f, 1.0f}) {
                    places.push_back({n, direction(v, 1), direction(l, side)});
                }
            }
            places.push_back({n, direction(v, 1), -direction(v, 1)});
        }
    }
    return places;
}

TEST_P(Brdf, IsFiniteAndNotNegativeWhereverLightAndViewerAre) {
    const auto places = nasty_places();
    for (const Model& model : models()) {
        const BrdfOnGpu reflected(model.file);
        const BrdfOnGpu weight(model.file, "mirror_weight(albedo, normal, to_viewer)");
        for (const glm::vec4& numbers : model.glosses) {
            for (const glm::vec3& albedo : albedos) {
                const auto light = reflected({albedo, numbers}, places);
                const auto mirror = weight({albedo, numbers}, places);
                for (std::size_t k = 0; k < places.size(); ++k) {
                    const Geometry& at = places[k];
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_TRUE(light[k][c] >= 0 && light[k][c] < 1e8f)
                            << model.file << " gloss " << numbers.x << ' ' << numbers.y << ' '
                            << numbers.z << " place " << k << ": " << light[k][c];
                        ASSERT_TRUE(mirror[k][c] >= 0 && mirror[k][c] <= 1) << mirror[k][c];
                    }
                    // Clear of the rounding of either's dot product.
                    if (glm::dot(glm::dvec3(at.normal), glm::dvec3(at.to_light)) < -1e-6) {
                        ASSERT_EQ(light[k], glm::vec3(0)) << model.file << " place " << k;
                    }
                }
            }
        }
    }
}

TEST_P(Brdf, LightAndViewerMayChangePlaces) {
    SCOPED_TRACE(seed());
    Directions directions(seed());
    std::vector<Geometry> places, swapped;
    for (int k = 0; k < 4096; ++k) {
        const glm::vec3 n = directions.anywhere();
        const glm::vec3 v = directions.above(n), l = directions.above(n);
        if (glm::dot(n, v) < 1e-3f || glm::dot(n, l) < 1e-3f) continue;
        places.push_back({n, v, l});
        swapped.push_back({n, l, v});
    }
    ASSERT_GT(places.size(), 4000u);
    for (const Model& model : models()) {
        const BrdfOnGpu reflected(model.file);
        for (const glm::vec4& numbers : model.glosses) {
            const auto there = reflected({{0.8f, 0.3f, 0.1f}, numbers}, places);
            const auto back = reflected({{0.8f, 0.3f, 0.1f}, numbers}, swapped);
            for (std::size_t k = 0; k < places.size(); ++k) {
                const glm::dvec3 n(places[k].normal);
                const double nl = glm::dot(n, glm::dvec3(places[k].to_light));
                const double nv = glm::dot(n, glm::dvec3(places[k].to_viewer));
                for (int c = 0; c < 3; ++c) {
                    const double f = there[k][c] / nl, g = back[k][c] / nv;
                    ASSERT_NEAR(f, g, 1e-6 + 2e-4 * std::max(f, g))
                        << model.file << " gloss " << numbers.x << " cosines " << nl << ' ' << nv;
                }
            }
        }
    }
}

// Compares with the formula at random places, and where a highlight is at its brightest.
template<class Reference>
void expect_formula(const BrdfOnGpu& on_gpu, const Gloss& gloss, double relative,
                    Reference&& reference) {
    SCOPED_TRACE(seed());
    Directions directions(seed());
    std::vector<Geometry> places;
    for (int k = 0; k < 4096; ++k) {
        const glm::vec3 n = directions.anywhere(), v = directions.above(n);
        const glm::vec3 mirrored = 2 * glm::dot(n, v) * n - v;
        const float spread = std::exp2(-float(k % 16));
        const glm::vec3 l = glm::normalize(mirrored + spread * directions.anywhere());
        if (glm::dot(n, v) > 0.01f && glm::dot(n, l) > 0.01f) places.push_back({n, v, l});
    }
    ASSERT_GT(places.size(), 3000u);
    const auto results = on_gpu(gloss, places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(places[k].normal));
        const glm::dvec3 v = glm::normalize(glm::dvec3(places[k].to_viewer));
        const glm::dvec3 l = glm::normalize(glm::dvec3(places[k].to_light));
        const glm::dvec3 expected = reference(n, v, l);
        for (int c = 0; c < 3; ++c) {
            ASSERT_NEAR(results[k][c], expected[c], 1e-6 + relative * expected[c])
                << "cosines " << glm::dot(n, v) << ' ' << glm::dot(n, l);
        }
    }
}

TEST_P(Brdf, LambertIsTheCosine) {
    const BrdfOnGpu on_gpu("lambert");
    const glm::vec3 albedo(0.8f, 0.3f, 2);
    expect_formula(on_gpu, {albedo, glm::vec4(0)}, 1e-5,
                   [&](const glm::dvec3& n, const glm::dvec3&, const glm::dvec3& l) {
                       return glm::dvec3(albedo) * glm::dot(n, l);
                   });
}

TEST_P(Brdf, BlinnPhongIsItsFormula) {
    const BrdfOnGpu on_gpu("blinn-phong");
    const glm::vec3 albedo(0.8f, 0.3f, 0);
    for (const float s : {0.0f, 1.0f, 50.0f, 1000.0f}) {
        const double specular = 0.25;
        expect_formula(on_gpu, {albedo, {s, specular, 0, 0}}, 1e-5 + 2e-6 * double(s),
                       [&](const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l) {
                           const double nh = glm::dot(n, glm::normalize(v + l));
                           const double normalised =
                               (s + 2.0) * (s + 4.0) / (8 * (s + std::exp2(-s / 2.0)));
                           return ((1 - specular) * glm::dvec3(albedo) +
                                   specular * normalised * std::pow(nh, double(s))) *
                                  glm::dot(n, l);
                       });
    }
}

// Walter et al. 2007 and Heitz 2014, as they write it.
TEST_P(Brdf, FacetsReflectOnceByTheirFormula) {
    const BrdfOnGpu on_gpu(
        "ggx", "single_scattering(specular_of(albedo, 0.0), normal, to_viewer, to_light, "
               "dot(normal, to_viewer), dot(normal, to_light))");
    const glm::vec3 albedo(0.9f, 0.6f, 0.3f);
    for (const float roughness : {0.0f, 0.05f, 0.2f, 0.5f, 1.0f}) {
        const double a = std::pow(std::max(double(roughness), 0.045), 2);
        const auto lambda = [&](double cosine) {
            const double tangent2 = (1 - cosine * cosine) / (cosine * cosine);
            return 0.5 * (std::sqrt(1 + a * a * tangent2) - 1);
        };
        expect_formula(on_gpu, {albedo, {roughness, 1, 0, 0}}, 1e-3,
                       [&](const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l) {
                           const glm::dvec3 h = glm::normalize(v + l);
                           const double nv = glm::dot(n, v), nl = glm::dot(n, l),
                                        nh = glm::dot(n, h);
                           const glm::dvec3 across = glm::cross(n, h);
                           const double slope = nh * nh * a * a + glm::dot(across, across);
                           const double distribution = a * a / (pi * slope * slope);
                           const double masking = 1 / (1 + lambda(nv) + lambda(nl));
                           const glm::dvec3 fresnel =
                               glm::dvec3(albedo) +
                               (1.0 - glm::dvec3(albedo)) * std::pow(1 - glm::dot(v, h), 5);
                           return pi * distribution * masking / (4 * nv * nl) * fresnel;
                       });
    }
}

// Schlick's term itself, where the surface is smooth.
TEST_P(Brdf, ASmoothMirrorShowsSchlicksPart) {
    const BrdfOnGpu on_gpu("ggx", "mirror_weight(albedo, normal, to_viewer)");
    const glm::vec3 albedo(0.9f, 0.6f, 0.3f);
    for (const float metallic : {0.0f, 1.0f}) {
        std::vector<Geometry> places;
        for (float degrees = 0; degrees <= 80; degrees += 5) {
            const float angle = glm::radians(degrees);
            const glm::vec3 v(std::sin(angle), 0, std::cos(angle));
            places.push_back({{0, 0, 1}, v, v});
        }
        const auto weights = on_gpu({albedo, {0, metallic, 0.04f, 0}}, places);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const glm::vec3 straight = metallic > 0 ? albedo : glm::vec3(0.04f);
            const float rim = std::pow(1 - places[k].to_viewer.z, 5.0f);
            const glm::vec3 schlick = straight + (1.0f - straight) * rim;
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(weights[k][c], schlick[c], 0.03) << k;
        }
    }
}

// Without a highlight the two glossy models are the matt one.
TEST_P(Brdf, NothingSpecularIsLambert) {
    Directions directions(1);
    std::vector<Geometry> places;
    for (int k = 0; k < 1024; ++k) {
        places.push_back({directions.anywhere(), directions.anywhere(), directions.anywhere()});
    }
    const glm::vec3 albedo(0.8f, 0.3f, 0.1f);
    const auto matt = BrdfOnGpu("lambert")({albedo, glm::vec4(0)}, places);
    const auto phong = BrdfOnGpu("blinn-phong")({albedo, {50, 0, 0, 0}}, places);
    const auto ggx = BrdfOnGpu("ggx")({albedo, {0.3f, 0, 0, 0}}, places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(phong[k][c], matt[k][c], 1e-6);
            EXPECT_NEAR(ggx[k][c], matt[k][c], 1e-6);
        }
    }
}

} // namespace
} // namespace isomotion::effects
