// Each operation's rule, against differences and closed forms.
#include "testing.h"

#include <cmath>

#include "central_difference.h"
#include "formula/graph/derivative.h"

namespace isomotion::formula {
namespace {

struct Derivatives {
    Graph graph;
    NodeId value, dx, dy, dxx, dxy, dyx;

    explicit Derivatives(std::string_view text) {
        const NodeId one = graph.constant(1), zero = graph.constant(0);
        const std::vector<NodeId> along_x{one, zero, zero}, along_y{zero, one, zero};
        value = parse(graph, text);
        dx = differentiate_inputs(graph, value, along_x);
        dy = differentiate_inputs(graph, value, along_y);
        dxx = differentiate_inputs(graph, dx, along_x);
        dxy = differentiate_inputs(graph, dx, along_y);
        dyx = differentiate_inputs(graph, dy, along_x);
    }
};

struct Rule {
    std::string text;
    double low = -2, high = 2; // of x and y: inside the domain and off the kinks, by 1/8 at least
};
void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.text; }

class Rules : public testing::TestWithParam<Rule> {};

TEST_P(Rules, AgreeWithDifferences) {
    const auto& [text, low, high] = GetParam();
    Derivatives d(text);
    const Program value = schedule_lowered(d.graph, d.value);
    const Program dx = schedule_lowered(d.graph, d.dx), dy = schedule_lowered(d.graph, d.dy);
    const Program dxx = schedule_lowered(d.graph, d.dxx), dxy = schedule_lowered(d.graph, d.dxy);
    const Program dyx = schedule_lowered(d.graph, d.dyx);
    constexpr std::uint64_t seed = 20;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 20; ++k) {
        const Point p{random.in(low, high), random.in(low, high), 0.5};
        SCOPED_TRACE(testing::Message() << testing::PrintToString(p));
        const auto moved = [&](const Program& program, int axis) {
            return [&program, axis, p](double h) mutable {
                Point q = p;
                q[std::size_t(axis)] += h;
                return run(program, q);
            };
        };
        EXPECT_LT(slope_error(moved(value, 0), run(dx, p)), 1e-9);
        EXPECT_LT(slope_error(moved(value, 1), run(dy, p)), 1e-9);
        EXPECT_LT(slope_error(moved(dx, 0), run(dxx, p)), 1e-9);
        EXPECT_LT(slope_error(moved(dx, 1), run(dxy, p)), 1e-9);
        const double mixed = run(dxy, p);
        EXPECT_NEAR(mixed, run(dyx, p), 1e-11 * (1 + std::abs(mixed)));
    }
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, Rules,
                         testing::Values(Rule{"-x"}, Rule{"x+y*x"}, Rule{"x-y*x"}, Rule{"x*y"},
                                         Rule{"x/y", 0.5, 2}, Rule{"(x*y-1)/(x^2+1)"},
                                         Rule{"1/x", 0.5, 2}, Rule{"x^2*y"}, Rule{"x^7"},
                                         Rule{"x^-3", 0.5, 2}, Rule{"x^30", -1.25, 1.25},
                                         Rule{"a*x+b*y+c"}));

// No two elements are least at one of the points.
INSTANTIATE_TEST_SUITE_P(LeastElements, Rules,
                         testing::Values(Rule{"least(blobs, (x-4*cx)^2*y + cy*x)"},
                                         Rule{"y*greatest(blobs, sin(cx*x) + cy*y)"},
                                         Rule{"least(blobs, x*(cx + y), cx*x^2*y)"},
                                         Rule{"least(blobs, x*cx + greatest(links, px*y))"}));

INSTANTIATE_TEST_SUITE_P(
    Functions, Rules,
    testing::Values(Rule{"exp(x*y)", -1, 1}, Rule{"log(x)*y", 0.5, 2}, Rule{"sqrt(x*y)", 0.5, 2},
                    Rule{"sin(x*y)"}, Rule{"cos(x+2*y)"}, Rule{"tan(x*y)", -1, 1},
                    Rule{"smoothmin(x*y, y^2 - 1, 20)"}, Rule{"sinh(x*y)"}, Rule{"cosh(x-y)"},
                    Rule{"tanh(x*y)"}, Rule{"asin(x*y)", -0.75, 0.75},
                    Rule{"acos(x*y)", -0.75, 0.75}, Rule{"asinh(x*y)"}, Rule{"acosh(x*y)", 1.25, 2},
                    Rule{"acosh(x) + y", -2, 0.875}, Rule{"erf(x*y)"}, Rule{"noise(x, 2*y, x*y)"},
                    Rule{"cbrt(x*y)", 0.5, 2}, Rule{"cbrt(x)*y", -2, -0.5}, Rule{"atan(x*y)"},
                    Rule{"atan2(y, x)", 0.5, 2}, Rule{"atan2(x - 3, y)*x", -2, -0.5},
                    Rule{"cos(2*atan2(x, y))", -2, -0.5}, Rule{"chebyshev(5,x*y)", -1, 1},
                    Rule{"chebyshev(30,x)+y*x", -0.875, 0.875}));

INSTANTIATE_TEST_SUITE_P(Powers, Rules,
                         testing::Values(Rule{"x^2.5", 0.5, 2}, Rule{"x^m*y", 0.5, 2},
                                         Rule{"x^y", 0.5, 2}, Rule{"pow(x*y,-0.7)", 0.5, 2},
                                         Rule{"2^(x*y)", -1, 1}, Rule{"abs(x-3)^1.5*y"},
                                         Rule{"pow(x, sin(y))", 0.5, 2}));

// Each on one side of its kinks.
INSTANTIATE_TEST_SUITE_P(
    Piecewise, Rules,
    testing::Values(Rule{"abs(x)*y", 0.125, 2}, Rule{"abs(x)*y", -2, -0.125},
                    Rule{"sign(x)*y+x", 0.125, 2}, Rule{"floor(x)*y+x", 0.125, 0.875},
                    Rule{"min(x*y,4)", 0.5, 1.75}, Rule{"max(x*y,4)", 2.125, 3},
                    Rule{"min(x*y,y,4)", 1.25, 1.75}, Rule{"max(x, 10, y*x)", 0.5, 2}));

INSTANTIATE_TEST_SUITE_P(Sums, Rules,
                         testing::Values(Rule{"sum(blobs, exp(-(x-cx)^2-y*cy))", -1, 1},
                                         Rule{"sum(blobs, sin(x*cx)*sum(links, cos(y*px)))"},
                                         Rule{"sum(blobs, sum(links, (x-cx*px)^3*y))"},
                                         Rule{"sum(blobs, weight*x)*sum(links, y^2)"},
                                         Rule{"sin(sum(blobs, cx*x*y))"}, Rule{"sum(blobs, x*y)"}));

double slope_at(std::string_view text, double x) {
    Derivatives d(text);
    return value_of(d.graph, d.dx, {x, 0, 0});
}

TEST(Kinks, ChooseAsDocumented) {
    EXPECT_EQ(slope_at("abs(x)", 0), 0);
    EXPECT_EQ(slope_at("sqrt(x^2)", 0), 0);
    EXPECT_EQ(slope_at("sqrt(x^2+y^2)", 0), 0);
    EXPECT_EQ(slope_at("sign(x)", 0), 0);
    EXPECT_EQ(slope_at("floor(x)", 3), 0);
    // A tie goes to the second argument, in the value and in the derivative.
    EXPECT_EQ(slope_at("min(x, 2*x)", 0), 2);
    EXPECT_EQ(slope_at("min(2*x, x)", 0), 1);
    EXPECT_EQ(slope_at("max(x, 2*x)", 0), slope_at("max(x, 2*x)", -1));
}

TEST(Kinks, MinAndMaxTakeTheSideTheyReturn) {
    for (const double x : {-2.0, -0.5, 0.5, 2.0}) {
        EXPECT_EQ(slope_at("min(x, 2*x)", x), x < 0 ? 2 : 1) << x;
        EXPECT_EQ(slope_at("max(x, 2*x)", x), x < 0 ? 1 : 2) << x;
    }
}

TEST(Derivative, ClosedForms) {
    for (const double x : {-1.75, -0.25, 0.0, 0.5, 2.0}) {
        const auto near = [&](std::string_view text, double expected) {
            EXPECT_NEAR(slope_at(text, x), expected, 1e-14 * (1 + std::abs(expected))) << text;
        };
        near("7", 0);
        near("a*m", 0);
        near("x", 1);
        near("x^5", 5 * std::pow(x, 4));
        near("exp(3*x)", 3 * std::exp(3 * x));
        near("sin(x)^2 + cos(x)^2", 0);
        near("tanh(x)", 1 / (std::cosh(x) * std::cosh(x)));
        near("atan(x)", 1 / (1 + x * x));
        near("asinh(x)", 1 / std::sqrt(1 + x * x));
        near("acosh(x)", x > 1 ? 1 / std::sqrt(x * x - 1) : 0);
        near("erf(x)", 2 * std::numbers::inv_sqrtpi * std::exp(-x * x));
        if (x != 0) near("cbrt(x)", std::pow(std::abs(x), -2.0 / 3) / 3);
        near("log(cosh(x))", std::tanh(x));
        near("sum(blobs, cx*x^2)", -0.75 * x);
    }
    EXPECT_EQ(slope_at("x^200", 1), 200);
    EXPECT_EQ(slope_at("x^0.5", 4), 0.25);
}

// 1 - x^2 would lose half the digits here.
TEST(Derivative, InverseSinesNearOne) {
    const double x = 1 - 0x1p-40;
    const double expected = 1 / std::sqrt(0x1p-40 * (2 - 0x1p-40));
    EXPECT_NEAR(slope_at("asin(x)", x), expected, 1e-14 * expected);
    EXPECT_NEAR(slope_at("acos(x)", x), -expected, 1e-14 * expected);
}

TEST(Derivative, InverseHyperbolicCosineNearOne) {
    const double x = 1 + 0x1p-40;
    const double expected = 1 / std::sqrt(0x1p-40 * (2 + 0x1p-40));
    EXPECT_NEAR(slope_at("acosh(x)", x), expected, 1e-14 * expected);
}

TEST(Derivative, FollowsTheLeavesItIsToldTo) {
    Graph g;
    const NodeId f = parse(g, "a*x + sum(blobs, cx*cy)");
    // With respect to parameter a: x. With respect to cx: the sum of cy.
    const NodeId by_a = differentiate(g, f, [](Graph& graph, NodeId leaf) {
        return graph.constant(graph[leaf].op == Op::parameter && graph[leaf].index == 0);
    });
    EXPECT_EQ(by_a, g.input(0));
    const NodeId by_cx = differentiate(g, f, [](Graph& graph, NodeId leaf) {
        return graph.constant(graph[leaf].op == Op::element && graph[leaf].second == 0);
    });
    EXPECT_EQ(by_cx, parse(g, "sum(blobs, cy)"));
}

TEST(Derivative, SharesTheValuesWork) {
    Graph g;
    const NodeId f = parse(g, "exp(sin(x*y))");
    const NodeId d = differentiate_inputs(g, f, {g.constant(1)});
    const Program both = schedule(g, std::array{f, d});
    int exponentials = 0, sines = 0;
    for (const auto& now : both.instructions) {
        exponentials += now.op == Op::exp;
        sines += now.op == Op::sin;
    }
    EXPECT_EQ(exponentials, 1);
    EXPECT_EQ(sines, 1);
}

// (-2)^x has values at integers only and so no slope; the graph may not hold log(-2).
TEST(Derivative, OfAPowerOfANegativeNumberIsZero) {
    EXPECT_EQ(slope_at("(-2)^x", 3), 0);
    EXPECT_EQ(value_of("(-2)^x", {3, 0, 0}), -8);
}

// Nothing is known of how values differ where random's arguments move, so nothing is proved there.
TEST(Derivative, OfRandomOverAnIntervalIsUnbounded) {
    Graph graph;
    const NodeId x = graph.input(0);
    const NodeId moves = graph.binary(Op::random, x, graph.constant(1));
    const NodeId rests = graph.binary(Op::random, graph.constant(3), graph.constant(1));
    std::vector<NodeId> slopes;
    for (const auto kind : {Slopes::generalized, Slopes::pointwise}) {
        for (const NodeId root : {moves, rests})
            slopes.push_back(differentiate_inputs(graph, root, {graph.constant(1)}, kind));
    }
    const Program program = schedule(graph, slopes);
    const auto at = [&](Interval value) {
        std::vector<Interval> found(slopes.size());
        Evaluator<Interval>(program).point({}, {&value, 1}, found);
        return found;
    };
    const std::vector<Interval> over = at({1, 2}), here = at(1.5);
    EXPECT_EQ(over[0], (Interval{-infinity, infinity}));
    for (const std::size_t k : {1, 2, 3}) EXPECT_EQ(over[k], Interval(0.0)) << k;
    for (const Interval slope : here) EXPECT_EQ(slope, Interval(0.0));
}

} // namespace
} // namespace isomotion::formula
