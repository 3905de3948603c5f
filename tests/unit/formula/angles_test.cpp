// Angles of atan2: where they jump, and which waves of them do not.
#include "formula/graph/angles.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formula/enclosure.h"
#include "formula/evaluate/evaluate.h"
#include "formula/field.h"
#include "formula/graph/continuity.h"
#include "formula/graph/parser.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

bool has(const std::string& formula, Op op) {
    Graph graph;
    const NodeId root = parse(graph, formula);
    for (NodeId id = 0; id <= root; ++id) {
        if (graph[id].op == op) {
            for (const NodeId below : nodes_below(graph, std::array{root}))
                if (below == id) return true;
        }
    }
    return false;
}

TEST(Angles, OfWholePeriodsHaveNoCut) {
    for (const char* wave :
         {"cos(atan2(y, x))", "sin(8*atan2(y, x))", "sin(z - 3*atan2(y, x) + 0.5)",
          "cos(-(2*atan2(y, x)))", "cos(4*(atan2(y, x)/2))", "tan(atan2(y, x)/2)",
          "sin(atan2(y, x) + 2*atan2(z, x))", "cos(5*atan(y/(sqrt(x^2 + y^2) + x)) * 2)"}) {
        EXPECT_FALSE(has(wave, Op::atan2)) << wave;
        EXPECT_TRUE(has(wave, Op::angle)) << wave;
    }
    for (const char* jump :
         {"atan2(y, x)", "cos(atan2(y, x)/2)", "sin(0.1*10.000000001*atan2(y, x))",
          "cos(a*atan2(y, x))", "exp(atan2(y, x))", "sin(atan2(y, x)^2)", "tan(atan2(y, x)/3)"}) {
        EXPECT_TRUE(has(jump, Op::atan2)) << jump;
        EXPECT_FALSE(has(jump, Op::angle)) << jump;
    }
}

// However many terms are beside it, or in whatever order.
TEST(Angles, AreFoundInLongSums) {
    std::string before = "cos(", behind = "cos(2*atan2(y, x)";
    for (int k = 0; k < 20; ++k) {
        before += fmt::format("sin({}*z) + ", k + 2);
        behind += fmt::format(" + sin({}*z)", k + 2);
    }
    EXPECT_FALSE(has(before + "2*atan2(y, x))", Op::atan2));
    EXPECT_FALSE(has(behind + ")", Op::atan2));
}

// Where an angle is between 0 and a number, its axis is a wall.
TEST(Angles, JumpAtTheirAxisWhateverTheirSlopesFoldTo) {
    for (const char* wave : {"cos(atan2(0, x)) + 0*z", "cos(atan2(x, x)) + 0*z",
                             "cos(atan2(0*y, x)) + 0*z", "tan(atan2(0, x)/2 + 1) + 0*z"}) {
        const Field field = make_field(wave, {});
        const EnclosurePrograms& programs = enclosure_programs(field);
        Evaluator<Interval> gradient(programs.gradient);
        std::array<Interval, 3> slopes;
        gradient.point({}, std::array{Interval(-1, 1), Interval(0.5, 1), Interval(0.0)}, slopes);
        EXPECT_EQ(slopes[0], Interval::entire()) << wave;
    }
}

TEST(Angles, OfHalfTheTangentAreFound) {
    for (const char* half : {"atan(y/(sqrt(x^2 + y^2) + x))", "2*atan(y/(x + sqrt(y^2 + x^2)))",
                             "atan((x - 1)/(sqrt((x - 1)^2 + z^2) + z))"})
        EXPECT_TRUE(has(half, Op::atan2)) << half;
    for (const char* other : {"atan(y/(sqrt(x^2 + y^2) - x))", "atan(x/(sqrt(x^2 + z^2) + y))",
                              "atan(2*y/(sqrt(x^2 + y^2) + x))", "atan(y/x)"})
        EXPECT_FALSE(has(other, Op::atan2)) << other;
}

double value(const std::string& formula, double x, double y, double z) {
    const Field field = make_field(formula, {});
    Evaluator<double> evaluator(field.value);
    double result = 0;
    evaluator.point({}, std::array{x, y, z}, {&result, 1});
    return result;
}

// The advice of former versions, and the function.
TEST(Angles, AreAsTheyWereWritten) {
    for (int k = 0; k < 64; ++k) {
        const double turn = (k + 0.5) * std::numbers::pi / 32, r = 0.1 + 0.05 * k;
        const double x = r * std::cos(turn), y = r * std::sin(turn);
        EXPECT_NEAR(value("2*atan(y/(sqrt(x^2 + y^2) + x))", x, y, 0), std::atan2(y, x), 1e-14);
        EXPECT_NEAR(value("cos(7*atan2(y, x) + z)", x, y, 0.3), std::cos(7 * turn + 0.3), 1e-13);
    }
    EXPECT_EQ(value("atan2(y, x)", -1, 0, 0), std::numbers::pi);
    EXPECT_EQ(value("atan2(-y, x)", -1, 0, 0), std::numbers::pi) << "-0 is 0";
    EXPECT_EQ(value("atan2(y, x)", 0, 0, 0), 0);
}

std::pair<Interval, Interval> value_and_jumps(const std::string& formula, Interval x, Interval y) {
    const Field field = make_field(formula, {});
    const EnclosurePrograms& programs = enclosure_programs(field);
    Evaluator<Interval> evaluator(programs.value), jumps(programs.jumps);
    std::array<Interval, 2> told;
    Interval result;
    evaluator.point({}, std::array{x, y, Interval(0.0)}, {&result, 1});
    jumps.point({}, std::array{x, y, Interval(0.0)}, told);
    return {result, told[0]};
}

TEST(Angles, AreEnclosedAcrossTheCut) {
    const Interval left{-1.01, -0.99}, about{-0.01, 0.01};
    const auto [wave, wave_jumps] = value_and_jumps("cos(8*atan2(y, x)) + 0*z", left, about);
    EXPECT_GT(wave.lo, 0.9);
    EXPECT_EQ(wave_jumps, Interval(0.0));
    const auto [angle, angle_jumps] = value_and_jumps("atan2(y, x) + 0*z", left, about);
    EXPECT_LT(angle.lo, -3.14);
    EXPECT_GT(angle.hi, 3.14);
    EXPECT_EQ(angle_jumps, Interval::entire());
    // Beside the cut, and across the other half of its line, nothing jumps.
    EXPECT_EQ(value_and_jumps("atan2(y, x) + 0*z", left, {0.001, 1}).second, Interval(0.0));
    EXPECT_EQ(value_and_jumps("atan2(y, x) + 0*z", {0.1, 2}, about).second, Interval(0.0));
    // At the axis waves have no limit.
    EXPECT_EQ(value_and_jumps("cos(8*atan2(y, x)) + 0*z", about, about).second, Interval::entire());
}

} // namespace
} // namespace isomotion::formula
