// Formulas far beyond what anyone types: programs write such ones, and mistakes make worse.
#include "testing.h"

#include <cmath>

#include <fmt/format.h>

#include "formula/derivative.h"
#include "formula/field.h"

namespace isomotion::formula {
namespace {

std::string repeat(std::string_view part, int times) {
    std::string text;
    for (int k = 0; k < times; ++k) text += part;
    return text;
}

class Nesting : public testing::TestWithParam<std::string> {};

TEST_P(Nesting, EndsInAnErrorAndNotInTheStack) {
    Graph graph;
    try {
        parse(graph, repeat(GetParam(), 100'000) + "x");
        FAIL() << "parsed";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.message(), "the formula is nested too deeply");
        EXPECT_GT(error.column(), 100);
        EXPECT_LT(std::string_view(error.what()).size(), 400u);
    }
}

INSTANTIATE_TEST_SUITE_P(Openings, Nesting,
                         testing::Values("(", "-", "+", "2^", "2^-", "sin(", "min(x,", "pow(2,",
                                         "chebyshev(2,", "-(", "x+("));

TEST(LargeFormula, ReasonableNestingIsFine) {
    EXPECT_EQ(value_of(repeat("(", 150) + "x" + repeat(")", 150), {7, 0, 0}), 7);
    EXPECT_EQ(value_of(repeat("-", 150) + "x", {7, 0, 0}), 7);
    EXPECT_NEAR(value_of(repeat("sin(", 100) + "x" + repeat(")", 100), {1, 0, 0}), 0.1688, 1e-4);
}

// Depth that doesn't nest the text: chains of terms, and definitions upon definitions.
TEST(LargeFormula, AChainIsNotNesting) {
    EXPECT_EQ(value_of(fmt::format("x{}", repeat("+1", 50'000)), {0.5, 0, 0}), 50'000.5);
    EXPECT_EQ(value_of(fmt::format("x{}", repeat("-y", 50'000)), {0.5, 1, 0}), -49'999.5);

    std::string text = "q = x;";
    for (int k = 0; k < 2000; ++k) text += fmt::format("q = sin(q) + {};", k % 7);
    double expected = 0.25;
    for (int k = 0; k < 2000; ++k) expected = std::sin(expected) + k % 7;
    EXPECT_EQ(value_of(text + "q", {0.25, 0, 0}), expected);
}

class Large : public testing::TestWithParam<int> {};

TEST_P(Large, FieldsAreMadeAndRight) {
    const int terms = GetParam();
    std::string text = "0";
    double value = 0, slope = 0;
    const Point p{0.3, -0.2, 0.1};
    for (int k = 1; k <= terms; ++k) {
        const double w = 1 + k * 1e-4;
        text += fmt::format("+sin({}*x)*y", w);
        value += std::sin(w * p[0]) * p[1];
        slope += w * std::cos(w * p[0]) * p[1];
    }
    const Field field = make_field(text, test_vocabulary());
    EXPECT_GT(field.value.registers, 3 * terms);
    FieldEvaluator<double> evaluator(field);
    const auto bindings = test_bindings();
    EXPECT_NEAR(evaluator.value(bindings, p), value, 1e-9 * terms);
    EXPECT_NEAR(evaluator.gradient(bindings, p)[0], slope, 1e-9 * terms);
    EXPECT_NEAR(evaluator.gradient(bindings, p)[1], value / p[1], 1e-9 * terms);
    EXPECT_EQ(evaluator.gradient(bindings, p)[2], 0);
}

// A term is a product, a sine, a product and a sum.
INSTANTIATE_TEST_SUITE_P(Nodes, Large, testing::Values(500, 12'500));

} // namespace
} // namespace isomotion::formula
