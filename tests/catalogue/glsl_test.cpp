// The GLSL of the catalogue's files against double on the CPU, on every back end, at the defaults
// and at both ends of the parameters' ranges.
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "recorded.h"
#include "surface_file.h"
#include "unit/gpu/every_backend.h"
#include "unit/shader/field_on_gpu.h"
#include "unit/shader/float_range.h"

namespace isomotion::catalogue {
namespace {

using shader::Probe;

class CatalogueGlsl : public gpu::EveryBackend {
protected:
    static constexpr std::uint64_t seed = 41;
    formula::Random random{seed};
    testing::ScopedTrace trace{__FILE__, __LINE__, "seed 41"};

    // Random points of the bounds; their middle, faces and corners; the axes, where many formulas
    // have kinks.
    std::vector<Probe> probes(const scene::BoundsAt& bounds, int count) {
        std::vector<Probe> all;
        const auto add = [&](const glm::dvec3& p) {
            const glm::dvec3 d(random.in(-1, 1), random.in(-1, 1), random.in(0.1, 1));
            all.push_back({glm::vec3(p), glm::vec3(glm::normalize(d))});
        };
        for (int k = 0; k < count; ++k) add(point_in(bounds, random));
        const glm::dvec3 middle = 0.5 * (bounds.min + bounds.max), half = bounds.max - middle;
        for (const glm::dvec3 shape :
             {glm::dvec3(0), {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, -1}}) {
            add(middle + half * shape);
            add(shape);
            add(0.5 * shape);
        }
        return all;
    }
};
ISOMOTION_ON_EVERY_BACKEND(CatalogueGlsl);

// What the GPU gave and what it might have given.
struct Result {
    float gpu;
    double cpu;
    shader::Range range;
    bool saturated, strained;

    bool agrees() const {
        if (std::isnan(cpu)) return false; // the catalogue has no such places
        if (range.nan && std::isnan(gpu)) return true;
        if (strained && !std::isfinite(gpu)) return true;
        return range.contains(double(gpu)) && (saturated || nearly(cpu));
    }
    // A bound of everything would prove nothing.
    bool is_narrow() const { return range.high - range.low <= 1e-2 * std::max(1.0, std::abs(cpu)); }
    double error() const { return std::abs(double(gpu) - cpu); }

private:
    bool nearly(double value) const { // the range's own arithmetic is double
        const double slack = 1e-12 * (std::abs(value) + 1);
        return range.low - slack <= value && value <= range.high + slack;
    }
};

// Calls visit(result, probe, function) for every output of each of the field's functions.
template<class Visit>
void compare(const Used& surface, const std::vector<Probe>& probes, Visit&& visit) {
    const auto bindings = surface.bindings();
    const auto on_gpu =
        shader::run_on_gpu(surface.field(), surface.at.surfaces[0].bindings, probes);
    std::array<double, 3> expected{};
    for (std::size_t f = 0; f < on_gpu.size(); ++f) {
        const auto& function = shader::field_functions[f];
        const formula::Program& program = surface.field().*function.program;
        formula::Evaluator<double> cpu(program);
        for (std::size_t k = 0; k < probes.size(); ++k) {
            const Probe& at = probes[k];
            const std::array<double, 6> inputs{at.p.x, at.p.y, at.p.z, at.d.x, at.d.y, at.d.z};
            const auto outputs = std::size_t(function.outputs);
            cpu.point(bindings, inputs, std::span(expected).first(outputs));
            const auto ranges = shader::float_ranges(program, bindings, inputs);
            for (std::size_t o = 0; o < outputs; ++o) {
                visit(Result{on_gpu[f][k][int(o)], expected[o], ranges.outputs[o], ranges.saturated,
                             ranges.strained},
                      at, fmt::format("{}[{}]", function.name, o));
            }
        }
    }
}

TEST_P(CatalogueGlsl, AgreesWithDoubles) {
    for (const Recorded& facts : recorded()) {
        int narrow = 0, all = 0;
        for (const auto& settings : both_ends(facts.name)) {
            const Used surface = used(facts.name, settings);
            const int points = surface.field().packing.empty() ? 90 : 30;
            compare(surface,
                    probes(surface.at.surfaces[0].bounds, settings.empty() ? points : points / 2),
                    [&](const Result& result, const Probe& at, const std::string& function) {
                        ++all;
                        if (result.is_narrow()) ++narrow;
                        ASSERT_TRUE(result.agrees()) << fmt::format(
                            "{} of {}, {}, at ({:.9g}, {:.9g}, {:.9g}): gpu {:.9g}, double "
                            "{:.12g}, floats may give {:.12g} to {:.12g}{}",
                            function, facts.name, describe(settings), at.p.x, at.p.y, at.p.z,
                            result.gpu, result.cpu, result.range.low, result.range.high,
                            result.range.nan ? " or NaN" : "");
                    });
            if (HasFatalFailure()) return;
        }
        const bool in_powers = facts.name.ends_with("_power"); // there to show how floats fail
        EXPECT_GE(narrow, (in_powers ? 0.25 : 0.95) * all) << facts.name;
    }
}

// What the files say of the three ways to a Chebyshev polynomial.
TEST_P(CatalogueGlsl, PowersOfHighOrderFailWhereProductsDoNot) {
    const auto worst_near_one = [&](const std::string& name) {
        const Used surface = used(name);
        double error = 0;
        std::vector<Probe> inside;
        for (int k = 0; k < 2000; ++k) {
            const double edge = random.in(0.98, 1) * (random.below(2) ? 1 : -1);
            inside.push_back({{edge, random.in(-0.2, 0.2), random.in(-0.2, 0.2)}, {1, 0, 0}});
        }
        compare(surface, inside,
                [&](const Result& result, const Probe&, const std::string& function) {
                    if (function == "field[0]") error = std::max(error, result.error());
                });
        return error;
    };
    EXPECT_LT(worst_near_one("chmutov_14"), 2e-5);
    EXPECT_LT(worst_near_one("chmutov_14_trig"), 5e-5);
    EXPECT_GT(worst_near_one("chmutov_14_power"), 5e-4);
    EXPECT_LT(worst_near_one("chmutov_22"), 5e-5);
    EXPECT_GT(worst_near_one("chmutov_22_power"), 0.5);
}

} // namespace
} // namespace isomotion::catalogue
