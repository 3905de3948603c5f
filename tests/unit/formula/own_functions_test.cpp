// Functions that a formula defines, and those that are composed of others.
#include "formula/graph/own_functions.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/graph/composed_functions.h"
#include "formula/graph/parser.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

std::string what_is_wrong(const std::string& text) {
    Graph graph;
    try {
        parse(text, test_vocabulary(), graph);
        return "none";
    } catch (const ParseError& error) {
        return std::to_string(error.column()) + ": " + error.message();
    }
}

TEST(OwnFunctions, AreTheirExpressionsWithArguments) {
    expect_same("f(u) = u^2 - 1; f(x) + f(y + z)", "x^2 - 1 + ((y + z)^2 - 1)");
    expect_same("ball(u, v, r) = u^2 + v^2 + z^2 - r^2; ball(x - 1, y, 0.5)",
                "(x - 1)^2 + y^2 + z^2 - 0.5^2");
    // Whole numbers make products, wherever they stand.
    expect_same("p(u, k) = u^k; p(x, 3) + p(y, 2)", "x^3 + y^2");
    expect_same("f(u)=2u; 3 f(x)", "3*(2*x)");
    expect_same("wave(u) = cos(8*u); wave(atan2(y, x))", "cos(8*atan2(y, x))");
}

TEST(OwnFunctions, MayCallEarlierOnesAndNameWhatIsDefined) {
    expect_same("f(u) = u + 1; g(u) = f(u)*f(2*u); g(x)", "(x + 1)*(2*x + 1)");
    expect_same("k = x + y; f(u) = u*k + a; k = z; f(2) + k", "2*(x + y) + a + z");
}

// Arguments hide coordinates, parameters and names, within the function alone.
TEST(OwnFunctions, HaveNamesOfTheirOwn) {
    expect_same("f(x, y) = x - 2*y; f(y, x) + x", "y - 2*x + x");
    expect_same("q = 3; f(q) = q^2; f(z) + q", "z^2 + 3");
    expect_same("f(a) = a + b; f(x) + a", "x + b + a");
    expect_same("mod(u, v) = u*v; mod(x, y)", "x*y");
}

TEST(OwnFunctions, GoThroughArrays) {
    expect_same("f(r) = sum(blobs, weight*(x - cx)) - r; f(a)", "sum(blobs, weight*(x - cx)) - a");
    expect_same("g(u) = (x - u)^2; sum(blobs, g(cx))", "sum(blobs, (x - cx)^2)");
    EXPECT_EQ(what_is_wrong("f(u) = sum(blobs, u*cx); sum(blobs, f(cy))"),
              "37: 'f' goes through 'blobs', and is called where that is done");
}

TEST(OwnFunctions, ThatAreWrongAreTold) {
    EXPECT_THAT(what_is_wrong("f(u) = f(u) + 1; f(x)"), testing::HasSubstr("8: 'f' calls itself"));
    EXPECT_EQ(what_is_wrong("f(u, v) = u; f(x)"), "14: f(u, v) takes 2 arguments, not 1");
    EXPECT_EQ(what_is_wrong("f(u, u) = u; f(x, y)"), "1: two arguments of 'f' are named 'u'");
    EXPECT_EQ(what_is_wrong("f(sin) = 1; x"), "1: 'sin' already has a meaning");
    EXPECT_EQ(what_is_wrong("sin(u) = u; x"), "1: 'sin' already has a meaning");
    EXPECT_EQ(what_is_wrong("a(u) = u; x"), "1: 'a' already has a value");
    EXPECT_THAT(what_is_wrong("f(u) = w; x"), testing::HasSubstr("8: unknown name 'w'"));
    EXPECT_THAT(what_is_wrong("f(u) = 2*x; g(x)"),
                testing::HasSubstr("13: there is no function 'g'"));
    EXPECT_EQ(what_is_wrong("f(u) = log(u) + x; f(-1)"), "20: f is not defined here");
}

TEST(OwnFunctions, AreNotReadAsProductsOrOtherFunctions) {
    expect_same("e(u) = u^2; e(x) + y", "x^2 + y");
    expect_same("tau(u) = u^2; tau(x) + y", "x^2 + y");
    expect_same("arg(u, v) = u - v; arg(x, y)", "x - y");
    EXPECT_EQ(what_is_wrong("ln(u) = 2*u; ln(x)"), "1: 'ln' already has a meaning");
    EXPECT_EQ(what_is_wrong("f(u) = u^2; f = 2; f(x)"), "13: 'f' is a function already");
    EXPECT_EQ(what_is_wrong("cx(u) = u^2; cx(x)"), "1: 'cx' already has a value");
    Vocabulary of_time;
    of_time.inputs = {"t"};
    Graph graph;
    EXPECT_THROW(parse("t(u) = 2*u; t(3)", of_time, graph), ParseError);
}

// As where they are written without a function.
TEST(OwnFunctions, TellConstantsWithoutAValue) {
    for (const char* text :
         {"f(u) = 1/u; x + f(0)", "f(u) = 0^u; x + f(-1)", "m2 = 0; f(u) = u/m2; x + f(y)",
          "f(u) = 1/u; g(v) = f(v - v) + x; g(y)", "x + mod(3, 0)", "x + y + mod(z, 0)",
          "x + atanh(1)", "x + csc(0)*1e-30"})
        EXPECT_NE(what_is_wrong(text), "none") << text;
    expect_same("k = 3; f(u) = chebyshev(k, u); f(x)", "chebyshev(3, x)");
}

TEST(OwnFunctions, TakeNoLongWhateverTheyAre) {
    std::string names = "f(a0";
    for (int k = 1; k < 50'000; ++k) names += fmt::format(",a{}", k);
    EXPECT_EQ(what_is_wrong(names + ") = x; x"), "1: 'f' has 50000 arguments; at most 32 are read");
    // Sums that share all that they are of: 2^16 ways to the bottom.
    std::string sums = "p0 = x; q0 = y; ";
    for (int k = 1; k <= 40; ++k)
        sums += fmt::format("p{0} = p{1} + q{1}; q{0} = p{1} - q{1}; ", k, k - 1);
    for (int k = 0; k < 300; ++k) sums += fmt::format("s{0} = sin({0}*p40); ", k);
    EXPECT_EQ(what_is_wrong(sums + "s7 + s8"), "none");
}

// Each level doubles what the one before has.
TEST(OwnFunctions, AreBoundedInSize) {
    std::string text = "f0(u) = u*x + 1; ";
    for (int k = 1; k < 60; ++k)
        text += fmt::format("f{0}(u) = f{1}(u + {0}) + f{1}(u*y + {0}); ", k, k - 1);
    EXPECT_THAT(what_is_wrong(text + "f59(z)"), testing::HasSubstr("the formula is too large"));
}

TEST(ComposedFunctions, HaveTheirValues) {
    struct Value {
        const char* text;
        double is;
    };
    for (const Value& value : {Value{"clamp(3, -1, 2)", 2},
                               {"mix(2, 4, 0.25)", 2.5},
                               {"step(1, 1)", 1},
                               {"step(1, 0.5)", 0},
                               {"step(1, 7)", 1},
                               {"smoothstep(0, 2, 1)", 0.5},
                               {"smoothstep(0, 2, 5)", 1},
                               {"mod(-1, 3)", 2},
                               {"mod(5.5, 2)", 1.5},
                               {"fract(-0.25)", 0.75},
                               {"ceil(1.2)", 2},
                               {"round(2.5)", 3},
                               {"trunc(-1.7)", -1},
                               {"length(2, 3, 6)", 7},
                               {"hypot(3, -4)", 5},
                               {"exp2(5)", 32},
                               {"log2(8)", 3},
                               {"log10(1000)", 3},
                               {"sec(0.5)", 1 / std::cos(0.5)},
                               {"csc(0.5)", 1 / std::sin(0.5)},
                               {"cot(0.5)", 1 / std::tan(0.5)},
                               {"atanh(0.5)", std::atanh(0.5)},
                               {"smoothmax(1, 1, 1)", 1.25},
                               {"e^2", std::exp(2)},
                               {"tau", 2 * M_PI},
                               {"ln(e)", 1}}) {
        Graph graph;
        const NodeId node = parse(value.text, test_vocabulary(), graph);
        ASSERT_TRUE(graph.is_constant(node)) << value.text;
        EXPECT_NEAR(graph[node].value, value.is, 1e-12) << value.text;
    }
}

TEST(ComposedFunctions, LeaveTheirNamesFree) {
    for (const Function& function : composed_functions()) {
        EXPECT_FALSE(is_reserved(function.name)) << function.name;
        EXPECT_EQ(find_function(function.name), &function);
    }
    for (const char* name : {"asinh", "acosh", "erf", "cbrt"}) {
        EXPECT_FALSE(is_reserved(name)) << name;
        Vocabulary with_parameter = test_vocabulary();
        with_parameter.parameters.emplace_back(name);
        Graph graph;
        EXPECT_EQ(parse(fmt::format("{}(x + 1) + {}", name, name), with_parameter, graph),
                  parse(fmt::format("{}*(x + 1) + {}", name, name), with_parameter, graph));
        expect_same(fmt::format("{0} = 3; {0}*x", name), "3*x");
        expect_same(fmt::format("{0}(u) = u^2; {0}(x)", name), "x^2");
        expect_same(fmt::format("f({0}) = 2*{0}; f(x)", name), "2*x");
    }
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.parameters.insert(vocabulary.parameters.end(), {"step", "e"});
    Graph graph;
    EXPECT_EQ(parse("step(x + 1) + e", vocabulary, graph),
              parse("step*(x + 1) + e*1", vocabulary, graph));
    expect_same("mix = 3; mix*x", "3*x");
}

} // namespace
} // namespace isomotion::formula
