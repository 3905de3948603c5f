// The fields of the catalogue's files against facts that have another source: the formulas of
// tests/unit/surface_formulas.cpp, the values that were recorded, and where the surface may go.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "recorded.h"
#include "surface_file.h"
#include "thorough.h"
#include "unit/shader/float_range.h"
#include "unit/surface_formulas.h"

namespace isomotion::catalogue {
namespace {

class CatalogueField : public testing::TestWithParam<Recorded> {
protected:
    static constexpr std::uint64_t seed = 31;
    formula::Random random{seed};
    testing::ScopedTrace trace{__FILE__, __LINE__, "seed 31"};
};

// The surface's formula as it was transcribed for the tests; forms of one surface share it.
const SurfaceFormula& transcription(const std::string& surface) {
    const std::string name = surface.substr(0, surface.rfind("_power"));
    const auto& all = surface_formulas();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const SurfaceFormula& f) { return f.name == name; });
    if (found == all.end()) throw std::runtime_error("no formula of " + name);
    return *found;
}

// A field, what its names stand for, and how far off doubles may be at a point.
struct Side {
    formula::Field field;
    formula::Bindings<double> bindings;

    double value(const formula::Point& p) const {
        return formula::FieldEvaluator<double>(field).value(bindings, p);
    }
    // Rounding errors are proportional to the unit: those of floats, 2^29 times as large, are
    // bounded by float_ranges.
    double rounding(const formula::Point& p) const {
        const auto range = shader::float_ranges(field.value, bindings, p).outputs[0];
        return 0x1p-29 * (range.high - range.low);
    }
};

Side transcribed(const SurfaceFormula& surface, const formula::Bindings<double>& file) {
    formula::Vocabulary vocabulary;
    formula::Bindings<double> bindings;
    for (const auto& [name, value] : surface.parameters) {
        vocabulary.parameters.push_back(name);
        bindings.parameters.push_back(double(float(value)));
    }
    if (!file.arrays.empty()) { // at s = 1 the file's cx, its first field, is ux
        vocabulary.arrays = {{"blobs", {{"ux", {}}, {"uy", {}}, {"uz", {}}}}};
        bindings.arrays = file.arrays;
    }
    return {formula::make_field(surface.text, vocabulary), bindings};
}

TEST_P(CatalogueField, IsTheTranscribedFormula) {
    const Used surface = used(GetParam().name);
    const SurfaceFormula& formula = transcription(GetParam().name);
    for (const Parameter& parameter : parameters_of(GetParam().name)) {
        for (const auto& [name, value] : formula.parameters) {
            if (name == parameter.name) {
                EXPECT_EQ(parameter.preset, value) << name;
            }
        }
    }
    const Side file{surface.field(), surface.bindings()};
    const Side other = transcribed(formula, surface.bindings());
    std::vector<double> tolerances;
    const int points = trials(90, 300);
    for (int k = 0; k < points; ++k) {
        const formula::Point p = as_inputs(point_in(surface.at.surfaces[0].bounds, random));
        const double tolerance = 4 * (file.rounding(p) + other.rounding(p));
        if (!std::isfinite(tolerance)) continue; // beside a pole floats may leave their range
        ASSERT_NEAR(file.value(p), other.value(p), tolerance) << testing::PrintToString(p);
        tolerances.push_back(tolerance);
    }
    ASSERT_GT(int(tolerances.size()), points * 29 / 30);
    const auto middle = tolerances.begin() + std::ptrdiff_t(tolerances.size() / 2);
    std::nth_element(tolerances.begin(), middle, tolerances.end());
    EXPECT_LT(*middle, 1e-8 * GetParam().span());
}

// A share q of n points, within five standard errors, should lie below the q-quantile: a field of
// another scale or of other bounds moves that share by more.
TEST_P(CatalogueField, HasTheRecordedValues) {
    constexpr int points = 8000;
    const Used surface = used(GetParam().name);
    const auto bindings = surface.bindings();
    formula::FieldEvaluator<double> field(surface.field());
    std::array<int, quantile_shares.size()> below{}, above{};
    int outside = 0;
    for (int k = 0; k < points; ++k) {
        const double value =
            field.value(bindings, as_inputs(point_in(surface.at.surfaces[0].bounds, random)));
        ASSERT_TRUE(std::isfinite(value));
        if (value < GetParam().least || value > GetParam().greatest) ++outside;
        for (std::size_t q = 0; q < below.size(); ++q) {
            if (std::abs(value) < GetParam().quantiles[q]) ++below[q];
            if (std::abs(value) > GetParam().quantiles[q]) ++above[q];
        }
    }
    // What 120,000 points found nothing of, 8,000 others find once or twice at most.
    EXPECT_LE(outside, 2);
    for (std::size_t q = 0; q < below.size(); ++q) {
        SCOPED_TRACE(testing::Message() << "quantile " << quantile_shares[q]);
        const double share = quantile_shares[q];
        const double error = 5 * std::sqrt(share * (1 - share) / points);
        // Not one number: a field that is constant away from the surface has many points on it.
        EXPECT_LE(double(below[q]) / points, share + error);
        EXPECT_LE(double(above[q]) / points, 1 - share + error);
    }
}

// These have lines on which F = 0 without changing sign; below 0 the level opens them to whiskers
// that go on without end.
bool has_whiskers(const std::string& surface, const std::vector<Setting>& settings) {
    const bool has_lines = surface == "cross_cap" || surface == "miter" || surface == "steiner";
    return has_lines && !settings.empty() && settings[0].second < 0;
}

TEST_P(CatalogueField, StaysInTheBoundsAsRecorded) {
    for (const auto& settings : ends_of_parameters(GetParam().name)) {
        SCOPED_TRACE(describe(settings));
        if (has_whiskers(GetParam().name, settings)) continue;
        const Used surface = used(GetParam().name, settings);
        const auto bindings = surface.bindings();
        formula::FieldEvaluator<double> field(surface.field());
        int positive = 0, negative = 0;
        for (int k = 0; k < 2000; ++k) {
            const double value =
                field.value(bindings, as_inputs(point_on(surface.at.surfaces[0].bounds, random)));
            ++(value > 0 ? positive : negative);
        }
        if (GetParam().sign > 0) {
            EXPECT_EQ(negative, 0);
        }
        if (GetParam().sign < 0) {
            EXPECT_EQ(positive, 0);
        }
        if (GetParam().sign == 0 && settings.empty()) {
            EXPECT_GT(positive, 0);
            EXPECT_GT(negative, 0);
        }
    }
}

// A parameter that moves nothing is none.
TEST_P(CatalogueField, ChangesWithEachParameter) {
    for (const Parameter& parameter : parameters_of(GetParam().name)) {
        const Used low = used(GetParam().name, {{parameter.name, parameter.min}});
        const Used high = used(GetParam().name, {{parameter.name, parameter.max}});
        const auto at_min = low.bindings(), at_max = high.bindings();
        formula::FieldEvaluator<double> field(low.field());
        int changes = 0;
        for (int k = 0; k < 2000; ++k) {
            const formula::Point p = as_inputs(point_in(low.at.surfaces[0].bounds, random));
            if ((field.value(at_min, p) < 0) != (field.value(at_max, p) < 0)) ++changes;
        }
        EXPECT_GT(changes, 2) << parameter.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, CatalogueField, testing::ValuesIn(recorded()),
                         [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace isomotion::catalogue
