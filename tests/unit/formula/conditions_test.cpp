// Conditions, choices by them, and the solids that they describe.
#include "formula/graph/conditions.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formula/enclosure.h"
#include "formula/field.h"
#include "formula/graph/continuity.h"
#include "formula/graph/derivative.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

double value_at(const std::string& text, const Point& p) {
    Graph graph;
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.allows_equation = false;
    const NodeId root = parse(text, vocabulary, graph);
    const Program program = schedule(graph, std::array{root});
    double f = 0;
    Evaluator<double>(program).point(test_bindings(), p, {&f, 1});
    return f;
}

TEST(Conditions, AreOneOrZero) {
    const Point p{0.5, -1, 2};
    for (const auto& [text, value] : std::vector<std::pair<std::string, double>>{
             {"(x < 1)", 1},
             {"(x > 1)", 0},
             {"(x < 0.5)", 0},
             {"(x <= 0.5)", 1},
             {"(x >= 0.5)", 1},
             {"(x ≥ 0.6)", 0},
             {"(x ≤ 0.4) + 3", 3},
             {"2*(y < 0)", 2},
             {"(-2 < y < 0 < z)", 1},
             {"(-2 < y < -1)", 0},
             {"(x < 1 and y < 0)", 1},
             {"(x < 1 && y > 0)", 0},
             {"(x > 1 or y < 0)", 1},
             {"(x > 1 or y > 0)", 0},
             {"(not x > 1)", 1},
             {"(x > 1 or x < 1 and y > 0)", 0}, // `and` binds more tightly
             {"(not (x > 1 or y > 0) and z)", 1},
             {"x < 1 ? 5 : 7", 5},
             {"x > 1 ? 5 : y > 0 ? 6 : 7", 7},
             {"if(z, 3, 4) + if(0, 10, 20)", 23},
             {"if(x < 1, if(y < 0, 1, 2), 3)", 1},
             {"max(x < 1, 0.25)", 1},
             {"(x == x) + 2*(x == x + 1)", 1},
             {"(x != x) + 2*(x != x + 1)", 2},
             {"if(x > 1 || y > 0 || 1 > 2, 1, 2)", 2},
         }) {
        EXPECT_EQ(value_at(text, p), value) << text;
    }
}

// A choice and what it stands for in numbers, over random points.
TEST(Conditions, ChooseTheValueOfABranch) {
    constexpr int seed = 21;
    Random random(seed);
    for (int k = 0; k < 200; ++k) {
        const Point p = random.point(2);
        const auto [x, y, z] = p;
        SCOPED_TRACE(fmt::format("seed {}, point {} {} {}", seed, x, y, z));
        EXPECT_EQ(value_at("if(x < y, x*z, sin(y))", p), x < y ? x * z : std::sin(y));
        EXPECT_EQ(value_at("x^2 + y^2 < 1 and z > 0 ? z : -y", p),
                  x * x + y * y < 1 && z > 0 ? z : -y);
        EXPECT_EQ(value_at("(x < 0 or y < z) ? 1 + x : y", p), x < 0 || y < z ? 1 + x : y);
        EXPECT_EQ(value_at("f(u, v) = u < v ? v - u : u*v; f(f(x, y), z)", p), [&] {
            const auto f = [](double u, double v) { return u < v ? v - u : u * v; };
            return f(f(x, y), z);
        }());
        // Not defined where the other branch is chosen.
        EXPECT_EQ(value_at("if(x > 0, log(x), x)", p), x > 0 ? std::log(x) : x);
    }
}

TEST(Conditions, OfTheSmallerAreNoChoices) {
    for (const auto& [choice, plain] : std::vector<std::pair<std::string, std::string>>{
             {"if(x < y, x, y)", "min(x, y)"},
             {"if(x > y, x, y)", "max(y, x)"},
             {"x < 0 ? -x : x", "abs(x)"},
             {"x >= 0 ? x : -x", "abs(x)"},
             {"if(1, x, y)", "x"},
             {"if(2 < 1, x, y)", "y"},
         }) {
        Graph graph;
        const NodeId root = parse(choice, test_vocabulary(), graph);
        EXPECT_EQ(root, parse(plain, test_vocabulary(), graph)) << choice;
    }
}

// A word that is a name stays one.
TEST(Conditions, WordsStayFree) {
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.parameters = {"and", "or", "not"};
    Graph graph;
    EXPECT_EQ(parse("x and y + not", vocabulary, graph), parse("x*and*y + not", vocabulary, graph));
}

double solid_at(const std::string& text, const Point& p) {
    const Field field = make_field(text, test_vocabulary());
    return FieldEvaluator<double>(field).value(test_bindings(), p);
}

// A surface that is an inequality is the boundary of its solid, within which F is below 0.
TEST(Conditions, DescribeSolids) {
    constexpr int seed = 22;
    Random random(seed);
    for (int k = 0; k < 200; ++k) {
        const Point p = random.point(2);
        const auto [x, y, z] = p;
        SCOPED_TRACE(fmt::format("seed {}, point {} {} {}", seed, x, y, z));
        const bool ball = x * x + y * y + z * z<1, above = z> 0.2, beside = x > y;
        EXPECT_EQ(solid_at("x^2 + y^2 + z^2 <= 1", p) < 0, ball);
        EXPECT_EQ(solid_at("1 >= x^2 + y^2 + z^2", p) < 0, ball);
        EXPECT_EQ(solid_at("x^2 + y^2 + z^2 < 1 and z > 0.2", p) < 0, ball && above);
        EXPECT_EQ(solid_at("x^2 + y^2 + z^2 < 1 or z > 0.2 and x > y", p) < 0,
                  ball || (above && beside));
        EXPECT_EQ(solid_at("not (x^2 + y^2 + z^2 < 1 or z > 0.2)", p) < 0, !(ball || above));
        EXPECT_EQ(solid_at("x^2 + y^2 + z^2 < 1 ? z > 0.2 : x > y", p) < 0, ball ? above : beside);
        EXPECT_EQ(solid_at("0.2 < z < 1", p) < 0, above && z < 1);
        EXPECT_EQ(solid_at("x^2 + y^2 + z^2 < 1 and 2*(z > 0.2)", p) < 0, ball && above);
    }
    const Field field = make_field("x^2 + y^2 + z^2 <= 1", test_vocabulary());
    EXPECT_EQ(FieldEvaluator<double>(field).value(test_bindings(), {1, 0, 0}), 0);
}

// In an equation a condition is a number.
TEST(Conditions, AreNumbersInEquations) {
    for (const Point& p : {Point{1, 2, 0}, {-1, 2, 0}}) {
        const double value = p[0] > 0 ? 1 : 0;
        EXPECT_EQ(solid_at("if(x > 0, 1, 0) = y", p), value - 2);
        EXPECT_EQ(solid_at("x > 0 = y", p), value - 2);
        EXPECT_EQ(solid_at("y = x > 0", p), 2 - value);
        EXPECT_EQ(solid_at("(x > 0) = 0", p), value);
    }
}

// However often a condition is joined with itself, and however many are joined.
TEST(Conditions, InLongChainsTakeNoTime) {
    std::string doubled = "c = x < 0; ";
    for (int k = 0; k < 40; ++k) doubled += "c = c or c; c = c and c; ";
    EXPECT_EQ(value_at(doubled + "c", {-1, 0, 0}), 1);
    std::string any = "(x < -2000", every = "(x < 2000";
    for (int k = 0; k < 2'000; ++k) {
        any += fmt::format(" or x*x + y < {}", -k);
        every += fmt::format(" and not x*x + y < {}", -k);
    }
    EXPECT_EQ(value_at(any + ")", {1, 0, 0}), 0);
    EXPECT_EQ(value_at(any + ")", {1, -2000.5, 0}), 1);
    EXPECT_EQ(value_at(every + ")", {1, 0, 0}), 1);
    EXPECT_EQ(value_at(every + ")", {1, -500, 0}), 0);
    EXPECT_LT(solid_at(any.substr(1), {1, -2000.5, 0}), 0);
}

// What encloses a choice, over boxes that hold the place where it turns and over others.
TEST(Conditions, AreEnclosedAndJump) {
    constexpr int seed = 23;
    Random random(seed);
    Graph graph;
    graph.fold_exactly();
    const NodeId root = parse("if(x < 0.25*y, log(2 - x), 1/(x + 3))", test_vocabulary(), graph);
    const NodeId slope =
        differentiate_inputs(graph, root, {graph.constant(1), graph.constant(0), graph.constant(0)},
                             Slopes::generalized);
    const NodeId jump = jumps(graph, root), gap = gaps(graph, root);
    const Program program = schedule(graph, std::array{root, slope, jump, gap});
    Evaluator<Interval> enclose(program);
    int undecided = 0;
    for (int k = 0; k < 400; ++k) {
        const double x = random.in(-2.5, 2.5), y = random.in(-2, 2), side = random.in(0, 0.5);
        const std::array<Interval, 3> box{Interval{x, x + side}, {y, y + side}, {0, 0}};
        std::array<Interval, 4> told;
        enclose.point(convert<Interval>(test_bindings()), box, told);
        const bool first = x + side < 0.25 * y, second = x >= 0.25 * (y + side);
        const bool has_jump = !(told[2] == Interval{0, 0});
        EXPECT_EQ(has_jump, !first && !second) << x << ' ' << y << ' ' << side;
        undecided += has_jump;
        if (has_jump) {
            EXPECT_EQ(told[1], Interval::entire());
        }
        for (const double at : {box[0].lo, box[0].hi}) {
            const double value = at < 0.25 * box[1].lo ? std::log(2 - at) : 1 / (at + 3);
            EXPECT_GE(value, told[0].lo - 1e-12);
            EXPECT_LE(value, told[0].hi + 1e-12);
        }
        // The logarithm has no value beyond 2, where it is not chosen.
        EXPECT_EQ(told[3], (Interval{0, 0}));
    }
    EXPECT_GT(undecided, 20);
    EXPECT_LT(undecided, 300);
}

// In a branch that is not taken, nothing is divided by 0 everywhere, and nothing lacks a value.
TEST(Conditions, LeaveOutWhatIsNotTaken) {
    Graph graph;
    graph.fold_exactly();
    const NodeId root =
        parse("if(x > 0, y/(a - 1.25) + log(-1 - x^2), z) - 0.5", test_vocabulary(), graph);
    const std::array outputs{within_gaps(graph, root), divided_by_0(graph, root)};
    const Program program = schedule(graph, outputs);
    Evaluator<Interval> enclose(program);
    const auto at = [&](double x) {
        std::array<Interval, 2> told;
        const std::array<Interval, 3> box{Interval{x, x + 0.1}, {1, 1.1}, {0.4, 0.6}};
        enclose.point(convert<Interval>(test_bindings()), box, told);
        return told;
    };
    EXPECT_GT(at(1)[0].lo, 0);
    EXPECT_EQ(at(-1)[0], (Interval{0, 0}));
    EXPECT_EQ(at(-1)[1], (Interval{0, 0}));
}

} // namespace
} // namespace isomotion::formula
