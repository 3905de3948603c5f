// Every operation of the language in balls, against its meaning on doubles: at points, and a ball
// against its members. Arguments reach past the ends of what has a value.
#include "arb/ball_program.h"

#include "unit/formula/testing.h"

namespace isomotion::roots_arb {
namespace {

using ball::Ball;
using ball::BallProgram;

constexpr unsigned seed = 31;

class EveryOperation : public testing::TestWithParam<const char*> {
protected:
    EveryOperation() {
        const formula::NodeId root = formula::parse(graph, GetParam());
        whole = formula::schedule(graph, std::array{root});
        lowered = formula::schedule_lowered(graph, root);
        RecordProperty("seed", int(seed));
    }
    Ball run(const formula::Program& program, const std::array<Ball, 3>& p, slong precision) const {
        Ball f;
        BallProgram(program).evaluate(formula::test_bindings(), p, {&f, 1}, precision);
        return f;
    }

    formula::Graph graph;
    formula::Program whole, lowered;
    formula::Random random{seed};
};

TEST_P(EveryOperation, IsThatOfDoublesAtPoints) {
    int bounded = 0;
    for (int k = 0; k < 400; ++k) {
        // Every fourth point has small integers, where rules have exceptions.
        formula::Point p = random.point(3);
        if (k % 4 == 0) {
            for (double& c : p) c = std::round(c);
        }
        const double f = formula::run(lowered, p);
        const Ball ball = run(lowered, {Ball(p[0]), Ball(p[1]), Ball(p[2])}, 48);
        if (!ball.is_finite()) continue;
        ++bounded;
        EXPECT_TRUE(arb_contains(ball.get(), Ball(f).get()))
            << f << " at " << p[0] << " " << p[1] << " " << p[2] << ", seed " << seed;
    }
    EXPECT_GT(bounded, 100);
}

TEST_P(EveryOperation, HoldsItsMembers) {
    int bounded = 0;
    for (int k = 0; k < 400; ++k) {
        const double reach = std::exp2(-random.below(12));
        const formula::Point p = random.point(3);
        std::array<Ball, 3> box, member;
        for (std::size_t c = 0; c < 3; ++c) {
            box[c] = Ball(p[c] - reach, p[c] + reach);
            member[c] =
                Ball(std::clamp(p[c] + reach * random.in(-1, 1), p[c] - reach, p[c] + reach));
        }
        const Ball wide = run(whole, box, 64), exact = run(whole, member, 200);
        if (!wide.is_finite() || !exact.is_finite()) continue;
        ++bounded;
        EXPECT_TRUE(arb_contains(wide.get(), exact.get()))
            << "at " << p[0] << " " << p[1] << " " << p[2] << " +- " << reach << ", seed " << seed;
    }
    EXPECT_GT(bounded, 100);
}

INSTANTIATE_TEST_SUITE_P(
    Balls, EveryOperation,
    testing::Values("-x", "abs(x - y)", "sign(x)", "sqrt(x)", "exp(x*y)", "log(x)", "sin(3*x)",
                    "cos(3*x)", "tan(x/4)", "sinh(x)", "cosh(x)", "tanh(x)", "asin(x)", "acos(x)",
                    "asinh(x)", "acosh(x)", "acosh(2 + x)", "erf(x)", "cbrt(x)", "cbrt(x/9)",
                    "atan(x)", "atan2(y, x)", "cos(3*atan2(y, x))", "sin(atan2(x - y, z) - z)",
                    "floor(x)", "x + y - z", "x*y", "x^2", "x^7", "x/y", "min(x, y)", "max(x, y)",
                    "smoothmin(x, y, 1)", "smoothmin(x, y, z)", "abs(x)^2.5", "abs(x)^y",
                    "pow(x, 3)", "chebyshev(9, x/2)", "chebyshev(24, x/3)", "noise(x, y, z)",
                    "fbm(x, y, z, 3)", "a*x + b*y + c", "sum(blobs, weight*exp(-(x - cx)^2))",
                    "sum(blobs, cx*sum(links, px*abs(y - py)))",
                    "least(blobs, (x - cx)^2 + (y - cy)^2)",
                    "greatest(blobs, cx*x + cy*y, cx - x)"));

// Against intervals, whose ends belong to them.
TEST(Ball, IsInAnIntervalOrApart) {
    constexpr double infinity = formula::infinity;
    const double after_one = std::nextafter(1.0, 2.0);
    const Ball one(1.0), wide(0.0, 1.0);
    EXPECT_TRUE(one.is_in(1, 1));
    EXPECT_TRUE(one.is_in(-infinity, 1));
    EXPECT_FALSE(one.is_in(after_one, 2));
    EXPECT_FALSE(one.is_apart_from(1, 2));
    EXPECT_TRUE(one.is_apart_from(after_one, infinity));
    EXPECT_TRUE(one.is_apart_from(-infinity, std::nextafter(1.0, 0.0)));
    EXPECT_TRUE(wide.is_in(-1e-8, 1 + 1e-8));
    EXPECT_FALSE(wide.is_in(0.1, 2));
    EXPECT_FALSE(wide.is_apart_from(0.5, 0.5));
    EXPECT_FALSE(wide.is_apart_from(1, 2));
    EXPECT_TRUE(wide.is_apart_from(1 + 1e-8, 2));
    // A ball of numbers that no double tells from 1.
    Ball close(1.0);
    arb_add_error_2exp_si(close.get(), -3000);
    EXPECT_FALSE(close.is_in(1, 2));
    EXPECT_FALSE(close.is_apart_from(1, 2));
    EXPECT_TRUE(close.is_apart_from(after_one, 2));
    // Without bounds it says nothing.
    Ball any;
    arb_indeterminate(any.get());
    EXPECT_FALSE(any.is_in(-1e300, 1e300));
    EXPECT_FALSE(any.is_apart_from(-infinity, infinity));
}

} // namespace
} // namespace isomotion::roots_arb
