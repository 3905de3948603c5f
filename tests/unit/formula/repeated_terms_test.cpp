// Sums over elements have the values of the terms that were written out.
#include "formula/graph/repeated_terms.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formula/enclosure.h"
#include "formula/field.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

using WrittenTerm = std::function<std::string(Random&)>;

std::string joined(int count, Random& random, const std::string& between, const WrittenTerm& term) {
    std::string all;
    for (int k = 0; k < count; ++k) all += (k > 0 ? between : "") + term(random);
    return all;
}

// A number with two decimals, of which some are 0, 1 or -1.
std::string number(Random& random) { return fmt::format("{:.2f}", random.in(-1.3, 1.3)); }

std::string ball(Random& random) {
    return fmt::format("((x - {})^2 + (y - {})^2 + (z - {})^2)", number(random), number(random),
                       number(random));
}

const std::vector<WrittenTerm> kinds_of_terms{
    [](Random& r) { return "exp(-8*" + ball(r) + ")"; },
    [](Random& r) { return number(r) + "/(" + ball(r) + " + 0.01)"; },
    [](Random& r) { return number(r) + "*sqrt(" + ball(r) + ")"; },
    [](Random& r) { return "sin(" + number(r) + "*x + y*" + number(r) + " + a)"; },
    [](Random& r) { return "max(0, " + number(r) + " - " + ball(r) + ")^2"; },
    [](Random& r) { return "abs(x - " + number(r) + ")^0.5*b"; },
    [](Random& r) { return "atan2(y - " + number(r) + ", z + " + number(r) + ")"; },
    [](Random& r) {
        return "x^" + fmt::format("{:.0f}", r.in(1, 9)) + "*sin(" + number(r) + "*y)";
    },
};

struct Pair {
    Field written_out, of_arrays;
    std::vector<ElementNumbers> arrays;
};

Pair pair_of(const std::string& text) {
    Pair pair{make_field(text, test_vocabulary()), {}, {}};
    pair.of_arrays = make_field(text, test_vocabulary(), &pair.arrays);
    return pair;
}

Bindings<double> bindings_of(const Pair& pair) {
    Bindings<double> bindings = test_bindings();
    for (const ElementNumbers& numbers : pair.arrays)
        bindings.arrays.push_back({int(numbers.front().size()), numbers});
    return bindings;
}

void expect_equal_values(const Pair& pair, Random& random, double tolerance) {
    const Bindings<double> bindings = bindings_of(pair);
    FieldEvaluator<double> written_out(pair.written_out), of_arrays(pair.of_arrays);
    for (int k = 0; k < 20; ++k) {
        const std::array<double, 3> p{random.in(-2, 2), random.in(-2, 2), random.in(-2, 2)};
        const double value = written_out.value(bindings, p);
        EXPECT_NEAR(of_arrays.value(bindings, p), value, tolerance * (1 + std::abs(value)));
        const auto slopes = written_out.gradient(bindings, p);
        const auto others = of_arrays.gradient(bindings, p);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(others[axis], slopes[axis], tolerance * (1 + std::abs(slopes[axis])));
        }
    }
}

TEST(RepeatedTerms, SumsHaveTheSameValues) {
    constexpr int seed = 11;
    Random random(seed);
    for (const WrittenTerm& term : kinds_of_terms) {
        for (const char* between : {" + ", " - "}) {
            const std::string text =
                "x^2 + b*y - 0.01*(" + joined(900, random, between, term) + ") + z";
            SCOPED_TRACE(fmt::format("seed {}: {:.200}", seed, text));
            const Pair pair = pair_of(text);
            EXPECT_GE(pair.arrays.size(), 1);
            EXPECT_LT(pair.of_arrays.value.instructions.size(),
                      pair.written_out.value.instructions.size() / 2);
            expect_equal_values(pair, random, 1e-11);
        }
    }
}

TEST(RepeatedTerms, LeastAndGreatestHaveTheSameValues) {
    constexpr int seed = 12;
    Random random(seed);
    for (const char* choice : {"min", "max"}) {
        const std::string text =
            fmt::format("{}(x + 3, {}, y - a*x) + c*z", choice, joined(700, random, ", ", ball));
        SCOPED_TRACE(fmt::format("seed {}: {:.200}", seed, text));
        const Pair pair = pair_of(text);
        EXPECT_EQ(pair.arrays.size(), 1);
        expect_equal_values(pair, random, 1e-13);
    }
}

TEST(RepeatedTerms, OfSeveralKindsAreSeveralArrays) {
    constexpr int seed = 13;
    Random random(seed);
    const std::string balls = "min(" + joined(150, random, ", ", ball) + ")";
    const std::string waves = joined(150, random, " + ", kinds_of_terms[3]);
    const Pair pair = pair_of("max(" + balls + " - 0.1, 0.01*(" + waves + ")) - 0.2*" + balls);
    ASSERT_EQ(pair.arrays.size(), 2);
    // Numbers that all terms share are no fields: a ball has its centre alone.
    EXPECT_EQ(std::min(pair.arrays[0].size(), pair.arrays[1].size()), 2);
    EXPECT_EQ(std::max(pair.arrays[0].size(), pair.arrays[1].size()), 3);
    expect_equal_values(pair, random, 1e-11);
}

// "x^2" in place of "(x - 0)^2".
TEST(RepeatedTerms, TakesACentreOf0ForACentre) {
    std::string text = "-1";
    for (int k = 0; k < 101; ++k) text += fmt::format(" + exp(-(x - {})^2)", k - 50);
    const Pair pair = pair_of(text);
    ASSERT_EQ(pair.arrays.size(), 1);
    ASSERT_EQ(pair.arrays[0].size(), 1);
    EXPECT_EQ(pair.arrays[0][0].size(), 101);
}

// A square of an element's expression is known not to be negative.
TEST(RepeatedTerms, KeepsSquares) {
    constexpr int seed = 14;
    Random random(seed);
    const Pair pair = pair_of(joined(200, random, " + ", ball) + " + 1");
    ASSERT_EQ(pair.arrays.size(), 3); // one for each axis
    const Bindings<double> bindings = bindings_of(pair);
    Evaluator<Interval> bounds(enclosure_programs(pair.of_arrays).value);
    Interval f;
    const std::array<Interval, 3> box{Interval{-1, 1}, Interval{-1, 1}, Interval{-1, 1}};
    bounds.point(convert<Interval>(bindings), box, {&f, 1});
    EXPECT_GE(f.lo, 1 - 1e-9);
}

TEST(RepeatedTerms, FewStayAsTheyAreWritten) {
    constexpr int seed = 15;
    Random random(seed);
    for (const std::string& text :
         {joined(15, random, " + ", kinds_of_terms[0]), std::string("x^2 + y^2 + z^2 - 1"),
          "sum(blobs, " + joined(300, random, " + ", ball) + "*cx)"}) {
        const Pair pair = pair_of(text);
        EXPECT_TRUE(pair.arrays.empty()) << text.substr(0, 200);
        EXPECT_EQ(pair.of_arrays.root, pair.written_out.root);
    }
}

// Each power is a product of its own, or defined elsewhere than others.
TEST(RepeatedTerms, TermsWithOtherExponentsAreOthers) {
    std::string text = "-9";
    for (int k = 0; k < 15; ++k) text += fmt::format(" + (x + {})^{}.5", k + 3, k % 7);
    for (int k = 0; k < 40; ++k)
        text += fmt::format(" + (y + {})^{}", k + 3, k % 2 == 0 ? "1.7" : "2.3");
    const Pair pair = pair_of(text);
    ASSERT_EQ(pair.arrays.size(), 2);
    for (const ElementNumbers& numbers : pair.arrays) {
        ASSERT_EQ(numbers.size(), 1);
        EXPECT_EQ(numbers[0].size(), 20);
    }
}

// Sums over elements may fade to 0 where a logarithm or a power of the sum is moderate.
TEST(RepeatedTerms, BlendsStay) {
    constexpr int seed = 16;
    Random random(seed);
    const std::string fades =
        joined(40, random, " + ", [](Random& r) { return "exp(-400*sqrt(" + ball(r) + "))"; });
    const std::string powers =
        joined(40, random, " + ", [](Random& r) { return "abs(x - " + number(r) + ")^30.5"; });
    for (const std::string& blend :
         {"-log(" + fades + ")/400 - 0.1", "1 - 0.01*log(3*(2*(" + fades + ") + 0.1))",
          "(" + powers + ")^(1/30.5) - 1", "sqrt(" + powers + ") - 1"})
        EXPECT_TRUE(pair_of(blend).arrays.empty()) << blend.substr(0, 100);
    // Others are moderate themselves.
    EXPECT_EQ(
        pair_of("log(" + joined(40, random, " + ", kinds_of_terms[1]) + ") - 1").arrays.size(), 1);
    EXPECT_EQ(pair_of(fades + " - 0.1").arrays.size(), 1);
}

// A part that all terms share is a tree of 2^40 nodes.
TEST(RepeatedTerms, SharedPartsTakeNoTime) {
    std::string text = "u = a; ";
    for (int k = 0; k < 40; ++k) text += "u = sin(u)*cos(u); ";
    text += "x";
    for (int k = 1; k < 40; ++k) text += fmt::format(" + sin({}*y)*u", k);
    EXPECT_TRUE(pair_of(text).arrays.empty());
}

// Of sums that hold one another, the longest get the arrays.
TEST(RepeatedTerms, RollsTheLongestSums) {
    std::string text = "s = x; p = y; ";
    for (int k = 1; k < 200; ++k) text += fmt::format("s = s + sin({}*z); p = p*cos(s); ", k);
    const Pair pair = pair_of(text + "p - 0.1");
    ASSERT_FALSE(pair.arrays.empty());
    for (const ElementNumbers& numbers : pair.arrays) EXPECT_GT(numbers[0].size(), 180);
}

TEST(RepeatedTerms, StopsAtTheMostArrays) {
    Graph graph;
    NodeId sum = graph.input(0);
    for (int k = 0; k < 200; ++k) {
        const NodeId wave =
            graph.unary(Op::sin, graph.multiply(graph.constant(k + 0.5), graph.input(1)));
        sum = graph.add(sum, wave);
    }
    EXPECT_EQ(repeated_terms(graph, sum, max_arrays - 1).arrays.size(), 1);
    const RepeatedTerms none = repeated_terms(graph, sum, max_arrays);
    EXPECT_TRUE(none.arrays.empty());
    EXPECT_EQ(none.root, sum);
}

} // namespace
} // namespace isomotion::formula
