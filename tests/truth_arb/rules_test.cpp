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
TEST(RulesOnPaper, EndAtTheValuesOfTheirKeys) {
    constexpr slong precision = 400;
    std::mt19937 random(11);
    const auto number = [&] {
        const double size = std::pow(10, -9 + 18 * double(random()) / 0x1p32);
        return (random() % 2 == 0 ? size : -size) * double(random()) / 0x1p32;
    };
    for (int k = 0; k < 300; ++k) {
        const double from = number(), to = number();
        for (const Ease ease : {Ease::linear, Ease::smooth, Ease::cubic}) {
            SCOPED_TRACE(fmt::format("{:.17g} to {:.17g}, {}", from, to, int(ease)));
            const animation::Animation moving(
                {{"v", animation::Keys{{{0, from}, {1, to}, {2, from}}, ease}}}, {});
            // The first rule, and the one after it: both have the key's value at 1 s.
            for (const double within : {0.5, 1.5}) {
                formula::Graph g;
                const formula::NodeId value =
                    animation::Rules(moving, within, g, g.input(0)).track(0);
                const formula::NodeId off = g.subtract(value, g.constant(to));
                const formula::Program program = formula::schedule(g, std::array{off});
                const ball::Ball time(1.0);
                ball::Ball error;
                ball::BallProgram(program).evaluate({}, {&time, 1}, {&error, 1}, precision);
                EXPECT_TRUE(error.is_in(-1e-60, 1e-60)) << within;
            }
        }
    }
}

} // namespace
} // namespace isomotion
