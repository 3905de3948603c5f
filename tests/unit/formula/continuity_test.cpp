#include "formula/graph/continuity.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/formula/stranger_formula.h"

namespace isomotion::formula {
namespace {

using Box = std::array<Interval, 3>;

// A cube near the origin, small or large.
Box any_box(Random& random) {
    const Point corner = random.point(1.5);
    const double size = std::exp2(random.in(-12, 1));
    Box box;
    for (std::size_t i = 0; i < 3; ++i) box[i] = {corner[i], corner[i] + size};
    return box;
}

// What tells boxes in which a formula has no value, and the formula itself.
class Subject {
public:
    explicit Subject(std::string_view text)
        : bindings_(convert<Interval>(test_bindings())) {
        const NodeId root = parse(graph_, text);
        value_ = schedule_lowered(graph_, root);
        Graph g = graph_;
        without_ = schedule(g, std::array{without_value(g, root)});
        within_ = schedule(g, std::array{within_gaps(g, root), gaps(g, root)});
        by_0_ = schedule(g, std::array{divided_by_0(g, root), jumps(g, root)});
    }

    Interval without_value_over(const Box& box) const {
        Interval result;
        Evaluator<Interval>(without_).point(bindings_, box, {&result, 1});
        return result;
    }
    // within_gaps() and gaps()
    std::array<Interval, 2> gaps_over(const Box& box) const {
        std::array<Interval, 2> result;
        Evaluator<Interval>(within_).point(bindings_, box, result);
        return result;
    }
    // divided_by_0() and jumps()
    std::array<Interval, 2> by_0_over(const Box& box) const {
        std::array<Interval, 2> result;
        Evaluator<Interval>(by_0_).point(bindings_, box, result);
        return result;
    }
    double value(const Point& p) const { return run(value_, p); }

private:
    Graph graph_;
    Bindings<Interval> bindings_;
    Program value_, without_, within_, by_0_;
};

// Rays would look for its value all along.
TEST(WithoutValue, IsCertainWhereAParameterIs0) {
    Graph g;
    const NodeId root = parse(g, "z - sin(a*x)/a + y*floor(c*y)/c");
    const Program program = schedule(g, std::array{without_value(g, root)});
    const Interval some(1, 2);
    const std::array<Interval, 3> box{some, some, some};
    for (const std::array<double, 2>& ac : {std::array{0.0, 1.0}, {1.0, 0.0}, {-0.0, 0.0}}) {
        Bindings<double> bindings = test_bindings();
        bindings.parameters[0] = ac[0];
        bindings.parameters[2] = ac[1];
        Interval found;
        Evaluator<Interval>(program).point(convert<Interval>(bindings), box, {&found, 1});
        EXPECT_GT(found.lo, 0) << ac[0] << ", " << ac[1];
    }
    Interval found;
    Evaluator<Interval>(program).point(convert<Interval>(test_bindings()), box, {&found, 1});
    EXPECT_EQ(found, Interval(0));
}

TEST(WithoutValue, IsCertainWhereNoPointHasOne) {
    const Interval below{-2, -1}, across{-1, 1}, above{1, 2};
    struct Case {
        const char* formula;
        Interval x;
        bool is_certain;
    };
    for (const Case& c : {
             Case{"log(x)", below, true},
             Case{"log(x)", across, false},
             Case{"log(x)", above, false},
             Case{"y - 3*log(x)/2", below, true},
             Case{"x^0.3", below, true},
             Case{"x^0.3", {0, 1}, false},
             Case{"sqrt(x)", below, false}, // 0
             Case{"x^-1.5 + y", below, true},
             Case{"x^b", below, true},  // b is -0.75
             Case{"x^m", below, false}, // m is 3
             Case{"log(x)^2 + y", below, true},
             Case{"sum(blobs, log(x + 0*cx))", below, true},
             Case{"sqrt(log(x)) + abs(y)", below, true},
             Case{"exp(-log(x)) + sin(y)", below, true},
             // A mean of nothing.
             Case{"abs(y - max(x, 0)*y/max(x, 0)) - 1", below, true},
             Case{"sqrt((y - max(x, 0)^3*y/max(x, 0)^3)^2) - 1", below, true},
             Case{"sqrt((y - max(x, 0)^3*y/max(x, 0)^3)^2) - 1", across, false},
             Case{"y - sum(blobs, cx*max(0, x)^3)/sum(blobs, max(0, x)^3)", below, true},
             Case{"y - sum(blobs, cx*max(0, x)^3)/sum(blobs, max(0, x)^3)", across, false},
             Case{"y - sum(blobs, cx + max(0, x)^3)/sum(blobs, max(0, x)^3)", below, false},
             // The first element has a weight.
             Case{"y - sum(blobs, max(0, cx - x)^3*y)/sum(blobs, max(0, cx - x)^3)",
                  {0, 0.1},
                  false},
             Case{"y - sum(blobs, max(0, cx - x)^3*y)/sum(blobs, max(0, cx - x)^3)", above, true},
             // 0/0 by functions that are 0 at 0.
             Case{"z - tanh(max(0, b)*x)/max(0, b)", above, true}, // b is -0.75
             Case{"z - floor(max(0, b)*x)/max(0, b)", above, true},
             Case{"z - floor(x/4)/max(0, b)", above, true},
             Case{"z - floor(x)/max(0, b)", above, false},
             Case{"z - cos(max(0, b)*x)/max(0, b)", above, false},
             // What chooses, cuts or compares may have a value all the same.
             Case{"min(y, log(x))", below, false},
             Case{"max(y, log(x))", below, false},
             Case{"sign(log(x))", below, false},
         }) {
        const Interval found = Subject(c.formula).without_value_over({c.x, {1, 2}, {1, 2}});
        EXPECT_GE(found.lo, 0) << c.formula;
        EXPECT_EQ(found.lo > 0, c.is_certain)
            << c.formula << " over " << testing::PrintToString(c.x);
    }
}

// A choice has no value where the branch that is taken has none.
TEST(WithoutValue, FollowsTheBranchThatIsTaken) {
    Graph g;
    const NodeId x = g.input(0), zero = g.constant(0);
    const NodeId root = g.select(x, zero, g.unary(Op::log, x), x);
    const NodeId other = g.select(x, zero, x, g.unary(Op::log, g.unary(Op::negate, x)));
    const NodeId untaken = g.select(x, zero, x, g.unary(Op::log, x));
    const Program program = schedule(
        g, std::array{without_value(g, root), without_value(g, other), without_value(g, untaken)});
    const auto over = [&](Interval at) {
        std::array<Interval, 3> found;
        Evaluator<Interval>(program).point({}, Box{at, 0.0, 0.0}, found);
        EXPECT_EQ(found[2].lo, 0);
        return std::pair(found[0].lo > 0, found[1].lo > 0);
    };
    EXPECT_EQ(over({-2, -1}), std::pair(true, false));
    EXPECT_EQ(over({1, 2}), std::pair(false, true));
    EXPECT_EQ(over({-1, 1}), std::pair(false, false));
}

TEST(WithoutValue, IsNeverSaidWhereAPointHasOne) {
    int certain = 0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        Random random(seed);
        const std::string text = StrangerFormula(seed).text();
        const Subject subject(text);
        for (int k = 0; k < 20; ++k) {
            const Box box = any_box(random);
            if (!(subject.without_value_over(box).lo > 0)) continue;
            ++certain;
            for (int sample = 0; sample < 16; ++sample) {
                Point p;
                for (std::size_t i = 0; i < 3; ++i) p[i] = random.in(box[i].lo, box[i].hi);
                ASSERT_TRUE(std::isnan(subject.value(p)))
                    << "seed " << seed << ": " << text << " at " << testing::PrintToString(p);
            }
        }
    }
    EXPECT_GT(certain, 100);
}

TEST(WithinGaps, AreBoxesWhereAnOperationHasNoValue) {
    const Interval below{-2, -1}, across{-1, 1}, above{1, 2};
    for (const char* formula :
         {"min(y, log(x))", "max(log(x), y)", "sign(log(x))", "abs(y - max(x, 0)*y/max(x, 0)) - 1",
          "least(blobs, max(cx, log(x)))", "atan(x^0.3)", "min(3, sum(blobs, log(x + 0*cx)))"}) {
        SCOPED_TRACE(formula);
        const Subject subject(formula);
        EXPECT_GT(subject.gaps_over({below, {1, 2}, {1, 2}})[0].lo, 0);
        EXPECT_EQ(subject.gaps_over({across, {1, 2}, {1, 2}})[0].lo, 0);
        EXPECT_EQ(subject.gaps_over({above, {1, 2}, {1, 2}})[0].lo, 0);
    }
    EXPECT_EQ(Subject("min(x, sqrt(x))").gaps_over({below, {1, 2}, {1, 2}})[0].lo, 0);
}

// So that nothing is lost by passing them: enclosures there are the entire line.
TEST(WithinGaps, AreNowhereElseThanInGaps) {
    int within = 0, without = 0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        Random random(seed);
        const std::string text = StrangerFormula(seed).text();
        SCOPED_TRACE(fmt::format("seed {}: {}", seed, text));
        const Subject subject(text);
        for (int k = 0; k < 20; ++k) {
            const Box box = any_box(random);
            const auto [is_within, gap] = subject.gaps_over(box);
            without += subject.without_value_over(box).lo > 0;
            if (!(is_within.lo > 0)) continue;
            ++within;
            ASSERT_EQ(gap, Interval::entire());
        }
    }
    EXPECT_GT(within, without);
}

// max(0, b) is 0, as b is -0.75.
// An enclosure of exp(-2000) holds 0.
TEST(Jumps, OfLogarithmsAreWhereTheyMayBeOf0) {
    const Box box{Interval(-2000, 1), Interval(-2000, 1), Interval(-2000, 1)};
    const auto may_jump = [&](const char* text) {
        return !(Subject(text).by_0_over(box)[1] == Interval{0, 0});
    };
    for (const char* text : {"log(exp(x) + exp(y))", "log(2*exp(x)*exp(y)/3 + exp(z))",
                             "log(3 - tanh(x))", "log(exp(y)*(3 - tanh(z)))",
                             "log(cosh(x/99)*exp(y))", "log(exp(log(exp(x) + exp(y))) + exp(z))"})
        EXPECT_FALSE(may_jump(text)) << text;
    for (const char* text : {"log(x)", "log(x^2)", "log(exp(x) - exp(y))", "log(exp(x)*y)",
                             "log(exp(x) + y)", "log(exp(-x))", "log(exp(1/x) + 1)"})
        EXPECT_TRUE(may_jump(text)) << text;
}

TEST(DividedBy0, IsSaidWhereADivisorIs0Everywhere) {
    const Interval some{-1, 1}, above{1, 2};
    for (const char* formula :
         {"z - x/max(0, b)", "z - floor(x)/(3*max(0, b))", "z - exp(-(x^2 + y^2)/max(0, b))",
          "max(x/max(0, b), y) + z", "1/(1/max(0, b)) - x", "z - atan(y/abs(max(0, b)))",
          "sum(blobs, exp(-x^2/(cx*max(0, b)))) - 1", "z - 1/max(0, -x - 3)"}) {
        SCOPED_TRACE(formula);
        const auto [is_by_0, jump] = Subject(formula).by_0_over({some, some, some});
        EXPECT_GT(is_by_0.lo, 0);
        EXPECT_EQ(jump, Interval::entire());
    }
    for (const char* formula : {"z - x/b", "z - y/x", "x/2 + y", "z - 1/(x^2 + 1)"})
        EXPECT_FALSE(Subject(formula).by_0_over({some, above, above})[0].lo > 0) << formula;
}

// So that nothing is lost by passing such boxes.
TEST(DividedBy0, IsSaidOnlyWhereTheRootMayJump) {
    int said = 0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        Random random(seed);
        const std::string inner = StrangerFormula(seed).text();
        const std::string text =
            seed % 2 ? "z + (" + inner + ")/max(0, x)" : "tanh(y/max(0, x)) - (" + inner + ")";
        SCOPED_TRACE(fmt::format("seed {}: {}", seed, text));
        const Subject subject(text);
        for (int k = 0; k < 20; ++k) {
            const Box box = any_box(random);
            const auto [is_by_0, jump] = subject.by_0_over(box);
            EXPECT_GE(is_by_0.lo, 0);
            if (!(is_by_0.lo > 0)) continue;
            ++said;
            ASSERT_EQ(jump, Interval::entire());
        }
    }
    EXPECT_GT(said, 1000);
}

} // namespace
} // namespace isomotion::formula
