#include "formula/graph/numerator.h"

#include "testing.h"

namespace isomotion::formula {
namespace {

// Whether bounds show that the formula has no zero over x and y, where z is 1.
bool has_no_zero(const char* text, const Interval& x, const Interval& y) {
    Graph graph;
    graph.fold_exactly();
    const NodeId told = without_zero(graph, parse(graph, text));
    const std::array<Interval, 3> box{x, y, Interval(1)};
    Interval found;
    Evaluator<Interval>(schedule(graph, std::array{told}))
        .point(convert<Interval>(test_bindings()), box, {&found, 1});
    return found.lo > 0;
}

TEST(Numerators, KeepOff0BesidePoles) {
    const Interval across{-0.1, 0.1}, one{0.9, 1.1};
    for (const char* text :
         {"1/x", "y/x", "y - z/x", "tan(x + pi/2) - y", "1/x + 1/y", "y*(z + z/x)", "-2/(x*y) + z",
          "abs(y/x) - 1", "min(z/x, y)", "max(y, -(x^-3))", "abs(max(z/x, y))"})
        EXPECT_TRUE(has_no_zero(text, across, one)) << text;
}

TEST(Numerators, TellNothingWhereThereMayBeAZero) {
    const Interval wide{-2, 2};
    for (const char* text : {"1/x - y", "x/y", "y - x*tan(z)", "min(1/x, y)", "1/x + y*z^2",
                             "sin(1/x)", "x/x^2*(x + y)", "1/(x - y) - 1/(x + y)",
                             // A power of a pole is 0 there, and so may be what cuts off alike.
                             "(1/x)^(-301)", "tan(x + pi/2)^(-2.5)", "1/x - 2/x"})
        EXPECT_FALSE(has_no_zero(text, wide, wide)) << text;
}

TEST(Numerators, AreOfFormulasWithPolesAlone) {
    Graph graph;
    for (const char* text : {"x^2 + y^2 - 1", "x/3 + exp(y)", "max(x, y)", "log(x) - y"})
        EXPECT_TRUE(graph.is_constant(without_zero(graph, parse(graph, text)), 0)) << text;
}

// The larger of the sizes of F on both sides of the place where its sign changes between a and b.
double size_at_change(const char* text, Point a, Point b) {
    double at_a = value_of(text, a), at_b = value_of(text, b);
    for (int k = 0; k < 60; ++k) {
        Point middle;
        for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = 0.5 * (a[axis] + b[axis]);
        const double value = value_of(text, middle);
        const bool as_a = (value < 0) == (at_a < 0);
        (as_a ? a : b) = middle;
        (as_a ? at_a : at_b) = value;
    }
    return std::max(std::abs(at_a), std::abs(at_b));
}

// Where bounds show that there is no zero, F changes its sign by poles alone.
TEST(Numerators, HoldForRandomBoxes) {
    constexpr int seed = 5;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    int changes = 0;
    for (const char* text :
         {"y - x*tan(4*x*y)", "1/x + 1/y - 2", "(x^2 - y^2)/(x*y) - z", "x/(y - 0.3)^3 - z/(x + y)",
          "max(1/(x - y), x^2 + y^2 - 1)", "0.5 - abs(x)/(y + x^2)", "(z/(x^3 - y))^-3 + 1"}) {
        for (int k = 0; k < 400; ++k) {
            const double x = random.in(-2, 2), y = random.in(-2, 2), size = random.in(0, 0.5);
            if (!has_no_zero(text, {x, x + size}, {y, y + size})) continue;
            const Point a{random.in(x, x + size), random.in(y, y + size), 1};
            const Point b{random.in(x, x + size), random.in(y, y + size), 1};
            if ((value_of(text, a) < 0) == (value_of(text, b) < 0)) continue;
            ++changes;
            EXPECT_GT(size_at_change(text, a, b), 1e3) << text;
        }
    }
    EXPECT_GT(changes, 50);
}

} // namespace
} // namespace isomotion::formula
