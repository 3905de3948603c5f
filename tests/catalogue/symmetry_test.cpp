// The symmetry of each surface, of its field as the GPU computes it: F(g p) = F(p) for the
// generators g of its group.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "recorded.h"
#include "surface_file.h"
#include "symmetry.h"
#include "unit/gpu/every_backend.h"
#include "unit/shader/field_on_gpu.h"
#include "unit/shader/float_range.h"

namespace isomotion::catalogue {
namespace {

using shader::Probe;

struct Image {
    std::string generator;
    glm::dmat3 map;
    double sign; // of F(g p)/F(p)
};

std::vector<Image> images_of(const Recorded& facts) {
    std::vector<Image> images;
    const auto add = [&](const std::vector<std::string>& generators, double sign) {
        for (const std::string& generator : generators) {
            for (const glm::dmat3& map : maps_of(generator)) {
                images.push_back({generator, map, sign});
            }
        }
    };
    add(facts.symmetry, 1);
    add(facts.antisymmetry, -1);
    return images;
}

// One back end is enough: glsl_test.cpp holds all of them to the same values.
class CatalogueSymmetry : public testing::Test {
protected:
    void SetUp() override {
        context = gpu::open_if_available(gpu::Backend::egl);
        if (!context) context = gpu::open_if_available(gpu::Backend::osmesa);
        if (!context) GTEST_SKIP() << "no back end is available here";
    }

    std::unique_ptr<gpu::Context> context;
    static constexpr std::uint64_t seed = 51;
    formula::Random random{seed};
    testing::ScopedTrace trace{__FILE__, __LINE__, "seed 51"};
};

// How far two results for symmetric points may lie apart: floats round each of them, and the image
// of a point is rounded to floats, too.
class Tolerance {
public:
    explicit Tolerance(const Used& surface)
        : field_(surface.field())
        , bindings_(surface.bindings())
        , evaluate_(surface.field()) {}

    double at(const glm::vec3& p, const glm::vec3& image, const glm::dvec3& exact_image) {
        const auto slopes = evaluate_.gradient(bindings_, as_inputs(glm::dvec3(image)));
        const double moved = glm::distance(glm::dvec3(image), exact_image);
        // Twice the first order, for the curvature.
        return width(p) + width(image) + 2 * std::hypot(slopes[0], slopes[1], slopes[2]) * moved;
    }

private:
    double width(const glm::vec3& p) const {
        const auto range =
            shader::float_ranges(field_.value, bindings_, as_inputs(glm::dvec3(p))).outputs[0];
        return range.high - range.low;
    }

    const formula::Field& field_;
    formula::Bindings<double> bindings_;
    formula::FieldEvaluator<double> evaluate_;
};

TEST_F(CatalogueSymmetry, IsTheRecordedOne) {
    constexpr int points = 16;
    int symmetric = 0;
    for (const Recorded& facts : recorded()) {
        const auto images = images_of(facts);
        if (images.empty()) continue;
        ++symmetric;
        const Used surface = used(facts.name);
        std::vector<Probe> probes;
        for (int k = 0; k < points; ++k) {
            probes.push_back(
                {glm::vec3(point_in(surface.at.surfaces[0].bounds, random)), {1, 0, 0}});
        }
        for (const Image& image : images) {
            for (std::size_t k = 0; k < points; ++k) {
                probes.push_back({glm::vec3(image.map * glm::dvec3(probes[k].p)), {1, 0, 0}});
            }
        }
        const auto values =
            shader::run_on_gpu(surface.field(), surface.at.surfaces[0].bindings, probes)[0];

        Tolerance tolerance(surface);
        std::vector<double> tolerances;
        for (std::size_t i = 0; i < images.size(); ++i) {
            for (std::size_t k = 0; k < points; ++k) {
                const std::size_t at = points * (i + 1) + k;
                const glm::vec3 p = probes[k].p;
                const double may_differ =
                    tolerance.at(p, probes[at].p, images[i].map * glm::dvec3(p));
                EXPECT_NEAR(values[at].x, images[i].sign * values[k].x, may_differ)
                    << facts.name << ", " << images[i].generator << " at "
                    << testing::PrintToString(as_inputs(glm::dvec3(p)));
                tolerances.push_back(may_differ);
            }
        }
        const auto middle = tolerances.begin() + std::ptrdiff_t(tolerances.size() / 2);
        std::nth_element(tolerances.begin(), middle, tolerances.end());
        EXPECT_LT(*middle, 1e-3 * facts.span()) << facts.name << ": the test proves little";
    }
    EXPECT_GE(symmetric, 50);
}

TEST(SymmetryMaps, AreOrthogonalAndOfTheOrderTheyName) {
    const auto power = [](const glm::dmat3& map, int n) {
        glm::dmat3 result(1);
        for (int k = 0; k < n; ++k) result = map * result;
        return result;
    };
    const auto distance = [](const glm::dmat3& a, const glm::dmat3& b) {
        double worst = 0;
        for (int k = 0; k < 3; ++k) worst = std::max(worst, glm::distance(a[k], b[k]));
        return worst;
    };
    for (const auto& [name, order] :
         std::vector<std::pair<std::string, int>>{{"y->-y", 2},
                                                  {"inversion", 2},
                                                  {"x<->z", 2},
                                                  {"x<->y, z->-z", 2},
                                                  {"xyz cyclic", 3},
                                                  {"C2(x)", 2},
                                                  {"C7(z)", 7},
                                                  {"S4(z)", 4},
                                                  {"C5(icosahedral b)", 5}}) {
        SCOPED_TRACE(name);
        const glm::dmat3 map = maps_of(name).at(0);
        EXPECT_LT(distance(map * glm::transpose(map), glm::dmat3(1)), 1e-14);
        for (int n = 1; n < order; ++n) EXPECT_GT(distance(power(map, n), glm::dmat3(1)), 0.1);
        EXPECT_LT(distance(power(map, order), glm::dmat3(1)), 1e-14);
    }
    EXPECT_THROW(maps_of("x->y"), std::invalid_argument);
}

} // namespace
} // namespace isomotion::catalogue
