// Steps of cubics over bumps of a formula.
#include "formula/cubic_steps.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::formula {
namespace {

CubicSteps steps_of(const std::string& text, double radius = 1.5, double parameter = 1,
                    double operations = 1e7) {
    Vocabulary vocabulary;
    vocabulary.parameters = {"p"};
    const Field field = make_field(text, vocabulary);
    const Interval side{-radius, radius};
    const Region region{{{Interval(parameter)}, {}}, {side, side, side}};
    const Moment moment{{{parameter}, {}}, region.box};
    return cubic_steps(field, smoothness(field, {&region, 1}), {&moment, 1}, radius / 8, 32,
                       operations);
}

// Nothing to hide: round bodies, and waves that are longer than any step.
TEST(CubicSteps, AreAsLongAsAnyForRoundBodies) {
    for (const char* text :
         {"x^2 + y^2 + z^2 - 1", "sqrt(x^2 + y^2 + z^2) - 1", "exp(-x^2 - y^2 - z^2) - 0.5",
          "sin(2*x) + sin(2*y) + sin(2*z)", "max(x^2 + y^2 - 0.3, abs(z) - 0.5)", "z - 0.3",
          "x^2 + y^2 + z^2 + 1"}) {
        EXPECT_EQ(steps_of(text), CubicSteps{}) << text;
    }
}

TEST(CubicSteps, AreShorterWhereWavesAre) {
    double last = 1;
    for (const double k : {20.0, 40.0, 80.0}) {
        const CubicSteps steps = steps_of(fmt::format("sin({0}*x)*sin({0}*y)*sin({0}*z) - 0.6", k));
        EXPECT_LE(steps.longest, last) << k;
        EXPECT_LE(steps.first, steps.longest);
        // A wave has a length of 2 pi/k: no half of one is passed at once.
        EXPECT_LT(steps.longest * 1.5 / 8, 3.2 / k) << k;
        last = steps.longest;
    }
}

// A ray along a silhouette cuts off a corner, and random lines seldom do.
TEST(CubicSteps, AreShorterWhereEdgesAreSharp) {
    const std::string wedge = "log(exp({0}*(x + 0.3*y - 0.2)) + exp({0}*(y - 0.5*x + 0.1*z)))/{0}";
    EXPECT_EQ(steps_of(fmt::format(fmt::runtime(wedge), 4)), CubicSteps{});
    EXPECT_LE(steps_of(fmt::format(fmt::runtime(wedge), 32)).longest, 0.5);
    EXPECT_LE(steps_of(fmt::format(fmt::runtime(wedge), 100)).longest, 0.25);
    EXPECT_LE(steps_of("tanh(50*x) + tanh(50*y) + z").longest, 0.5);
}

// The unit of length does not matter, and that of F neither.
TEST(CubicSteps, ArePartsOfTheBounds) {
    const CubicSteps steps = steps_of("sin(30*x)*sin(30*y)*sin(30*z) - 0.6");
    EXPECT_LT(steps.longest, 1);
    EXPECT_EQ(steps, steps_of("1e6*(sin(30*x)*sin(30*y)*sin(30*z) - 0.6)"));
    EXPECT_EQ(steps, steps_of("sin(x/100)*sin(y/100)*sin(z/100) - 0.6", 1.5 * 3000));
}

TEST(CubicSteps, FollowParameters) {
    EXPECT_EQ(steps_of("sin(p*x) + sin(p*y) + sin(p*z) - 2", 1.5, 2), CubicSteps{});
    EXPECT_LT(steps_of("sin(p*x) + sin(p*y) + sin(p*z) - 2", 1.5, 60).longest, 1);
}

// Bounds judge kinks, cubics what lies between them.
TEST(CubicSteps, OfKinksAreThoseOfTheirParts) {
    EXPECT_EQ(steps_of("abs(abs(x^2 + y^2 + z^2 - 1) - 0.1) - 0.01"), CubicSteps{});
    for (const char* text : {"sin(40*x)*sin(40*y)*sin(40*z) - 0.6 + 0.01*abs(x + 1.4)",
                             "max(sin(40*x)*sin(40*y)*sin(40*z) - 0.9, z - 0.7)",
                             "abs(sin(20*x)) + abs(sin(20*y)) + abs(sin(20*z)) - 2.9"})
        EXPECT_LT(steps_of(text).first, 0.5) << text;
}

TEST(CubicSteps, OfDearFormulasAreNotLookedFor) {
    EXPECT_EQ(steps_of("sin(30*x)*sin(30*y)*sin(30*z) - 0.6", 1.5, 1, 1e3), CubicSteps{});
}

TEST(CubicSteps, TakeGapsAndPoles) {
    for (const char* text : {"log(x) + y", "1/x + 1/y + z", "tan(9*x) + y", "sqrt(-1 - x^2) + 0*y"})
        EXPECT_GT(steps_of(text).first, 0) << text;
}

} // namespace
} // namespace isomotion::formula
