// Rules of motion against what they are on paper, in ball arithmetic.
#include "animation/rules.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "arb/ball_program.h"
#include "formula/graph/program.h"

namespace isomotion {
namespace {

using animation::Ease;

// Where a rule ends off its last key's value, there is a gap between it and the next rule. A value
// in the gap is reached by neither, and what happens then is missed.
bool is_zero_after_a_second(const formula::Graph& g, formula::NodeId error,
                            const formula::Bindings<double>& bindings = {}) {
    const formula::Program program = formula::schedule(g, std::array{error});
    const ball::Ball time(1.0);
    ball::Ball value;
    ball::BallProgram(program).evaluate(bindings, {&time, 1}, {&value, 1}, 400);
    return value.is_in(-1e-60, 1e-60);
}

// Of all sizes from 1e-9 to 1e9.
double random_number(std::mt19937& random) {
    const double size = std::pow(10, -9 + 18 * double(random()) / 0x1p32);
    return (random() % 2 == 0 ? size : -size) * double(random()) / 0x1p32;
}

TEST(RulesOnPaper, EndAtTheValuesOfTheirKeys) {
    std::mt19937 random(11);
    for (int k = 0; k < 300; ++k) {
        const double from = random_number(random), to = random_number(random);
        for (const Ease ease : {Ease::linear, Ease::smooth, Ease::cubic}) {
            SCOPED_TRACE(fmt::format("{:.17g} to {:.17g}, {}", from, to, int(ease)));
            const animation::Animation moving(
                {{"v", animation::Keys{{{0, from}, {1, to}, {2, from}}, ease}}}, {});
            // The first rule, and the one after it: both have the key's value at 1 s.
            for (const double within : {0.5, 1.5}) {
                formula::Graph g;
                const formula::NodeId value =
                    animation::Rules(moving, within, g, g.input(0)).track(0);
                EXPECT_TRUE(is_zero_after_a_second(g, g.subtract(value, g.constant(to)))) << within;
            }
        }
    }
}

TEST(RulesOnPaper, EndAtTheValuesOfTheirSamples) {
    using animation::ElementSamples;
    using How = ElementSamples::Interpolation;
    std::mt19937 random(12);
    for (int k = 0; k < 300; ++k) {
        const double from = random_number(random), to = random_number(random);
        for (const How how : {How::linear, How::hermite}) {
            SCOPED_TRACE(fmt::format("{:.17g} to {:.17g}, {}", from, to, int(how)));
            ElementSamples::Rows rows{{0, 1, 2}, {0, 1, 2, 3}, {{from, to, from}}, {}};
            rows.values.push_back({random_number(random), random_number(random), 0});
            rows.velocities = {1, std::nullopt};
            const animation::Animation moving(
                {}, {{"drops",
                      1,
                      {{"x", animation::Column{0}}},
                      std::make_shared<const ElementSamples>(rows, how)}});
            // The rules before and after the second sample: both have its value at 1 s.
            for (const double within : {0.5, 1.5}) {
                formula::Graph g;
                animation::Rules rules(moving, within, g, g.input(0));
                const formula::NodeId value = g.sum(0, rules.field(0, 0));
                formula::Bindings<double> bindings;
                bindings.arrays = rules.columns();
                EXPECT_TRUE(is_zero_after_a_second(g, g.subtract(value, g.constant(to)), bindings))
                    << within;
            }
        }
    }
}

} // namespace
} // namespace isomotion
