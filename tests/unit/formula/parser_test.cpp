#include "testing.h"

#include <cmath>
#include <numbers>

namespace isomotion::formula {
namespace {

constexpr double x = 1.375, y = -0.625, z = 2.25;
constexpr double a = 1.25, b = -0.75, c = 0.5;

struct Reading {
    std::string text;
    double value;
};

void PrintTo(const Reading& reading, std::ostream* out) { *out << reading.text; }

class Grammar : public testing::TestWithParam<Reading> {};

TEST_P(Grammar, ReadsAsOnPaper) {
    const auto& [text, value] = GetParam();
    EXPECT_NEAR(value_of(text, {x, y, z}), value, 1e-13 * (1 + std::abs(value))) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Precedence, Grammar,
    testing::Values(Reading{"1 - 2 - 4", -5}, Reading{"16 / 4 / 2", 2}, Reading{"2 + 3*4", 14},
                    Reading{"(2 + 3)*4", 20}, Reading{"2*3^2", 18}, Reading{"-3^2", -9},
                    Reading{"(-3)^2", 9}, Reading{"-x^2", -x* x}, Reading{"--x", x},
                    Reading{"-+-+x", x}, Reading{"+x", x}, Reading{"2^3^2", 512},
                    Reading{"2^-3^2", 1.0 / 512}, Reading{"2^-1", 0.5}, Reading{"2*-3", -6},
                    Reading{"2--3", 5}, Reading{"2-+3", -1}, Reading{"x-y*z", x - y* z},
                    Reading{"x/y*z", x / y* z}, Reading{"x/(y*z)", x / (y * z)},
                    Reading{"-x*y", -x* y}, Reading{"x*-y^2", -x* y* y}, Reading{"x^2^0", x},
                    Reading{"-2^-2", -0.25}));

INSTANTIATE_TEST_SUITE_P(
    AsOnPaper, Grammar,
    testing::Values(
        Reading{"2x", 2 * x}, Reading{"2 x y", 2 * x* y}, Reading{"(x+1)(y+1)", (x + 1) * (y + 1)},
        Reading{"x(y+1)", x*(y + 1)}, Reading{"2x^2 y", 2 * x* x* y}, Reading{"-2x^2", -2 * x* x},
        Reading{"2^3x", 8 * x}, Reading{"a sin(x)b", a* std::sin(x) * b},
        Reading{"x - 2y", x - 2 * y}, Reading{"x*2y/4", x * 2 * y / 4},
        Reading{"3 pi", 3 * std::numbers::pi}, Reading{"2π", 2 * std::numbers::pi},
        Reading{"x² + y³", x* x + y* y* y}, Reading{"x⁻¹", 1 / x},
        Reading{"2^x²", std::pow(2, x* x)}, Reading{"x¹⁰", std::pow(x, 10)},
        Reading{"x²y²", x* x* y* y}, Reading{"(x+y)²", (x + y) * (x + y)}, Reading{"-x²", -x* x},
        Reading{"sin(x)²", std::sin(x) * std::sin(x)}, Reading{"x^{2+1}", x* x* x},
        Reading{"x^{2}y", x* x* y}, Reading{"|y|", -y}, Reading{"2|y|", -2 * y},
        Reading{"|y|x", -y* x}, Reading{"|x - 2*|y| - 3|", std::abs(x - 2 * std::abs(y) - 3)},
        Reading{"|(|y| - 1)(x)|", std::abs((std::abs(y) - 1) * x)},
        Reading{"|max(|y|, 0.1)|^2", y* y}, Reading{"x − y·z", x - y* z}, Reading{"−x × y", -x* y},
        Reading{"ln(z)", std::log(z)}, Reading{"arctan(x)", std::atan(x)}));

INSTANTIATE_TEST_SUITE_P(Equations, Grammar,
                         testing::Values(Reading{"x^2 = 1", x* x - 1}, Reading{"x = y", x - y},
                                         Reading{"x^2 + y^2 = 1 - z^2", x* x + y* y + z* z - 1},
                                         Reading{"a = x", a - x},
                                         Reading{"u = 2x; u = y", 2 * x - y}, Reading{"x = 0", x},
                                         Reading{"0 = x", -x}));

INSTANTIATE_TEST_SUITE_P(Numbers, Grammar,
                         testing::Values(Reading{"1e3", 1000}, Reading{"1E+3", 1000},
                                         Reading{"25e-2", 0.25}, Reading{".5", 0.5},
                                         Reading{"5.", 5}, Reading{"0.1", 0.1},
                                         Reading{"1e-300", 1e-300}, Reading{"007", 7},
                                         Reading{"pi", std::numbers::pi}));

INSTANTIATE_TEST_SUITE_P(
    Functions, Grammar,
    testing::Values(Reading{"abs(y)", -y}, Reading{"sign(y)", -1}, Reading{"sqrt(z)", 1.5},
                    Reading{"exp(x)", std::exp(x)}, Reading{"log(z)", std::log(z)},
                    Reading{"sin(x)", std::sin(x)}, Reading{"cos(x)", std::cos(x)},
                    Reading{"tan(x)", std::tan(x)}, Reading{"sinh(x)", std::sinh(x)},
                    Reading{"cosh(x)", std::cosh(x)}, Reading{"tanh(x)", std::tanh(x)},
                    Reading{"asin(y)", std::asin(y)}, Reading{"acos(y)", std::acos(y)},
                    Reading{"atan(x)", std::atan(x)}, Reading{"floor(y)", -1},
                    Reading{"asinh(y)", std::asinh(y)}, Reading{"acosh(z)", std::acosh(z)},
                    Reading{"acosh(y)", 0}, Reading{"erf(y)", std::erf(y)},
                    Reading{"cbrt(y)", std::cbrt(y)}, Reading{"cbrt(-8)", -2},
                    Reading{"min(x, y)", y}, Reading{"max(x, y)", x}, Reading{"min(x, y, -4)", -4},
                    Reading{"max(1, 2, x, 7, z)", 7}, Reading{"smoothmin(x, y, 0)", y},
                    Reading{"smoothmin(1, 1, 2)", 0.5}, Reading{"pow(z, y)", std::pow(z, y)},
                    Reading{"pow(z, -2)", 1 / (z * z)}, Reading{"z^0.5", 1.5},
                    Reading{"x^m", x* x* x}, Reading{"chebyshev(3, x)", 4 * x* x* x - 3 * x},
                    Reading{"chebyshev(1+1, x)", 2 * x* x - 1}, Reading{"chebyshev(0, x)", 1}));

INSTANTIATE_TEST_SUITE_P(Space, Grammar,
                         testing::Values(Reading{" \t x\n +\r\n y ", x + y},
                                         Reading{"min (x ,y)", y}, Reading{"x^ 2", x* x},
                                         Reading{"sum ( blobs , 1 )", 3}));

INSTANTIATE_TEST_SUITE_P(
    Definitions, Grammar,
    testing::Values(Reading{"q = x + y; q*q", (x + y) * (x + y)},
                    Reading{"p = x; q = p*y; p + q", x + x* y}, Reading{"q=1;\n\tq=q+1;\nq", 2},
                    // A definition hides a parameter of the same name from there on.
                    Reading{"b = a; a = 7; a + b", 7 + a}, Reading{"q = 2; sum(blobs, q)", 6},
                    Reading{"unused = sin(x); c", c}));

// The columns of test_bindings: field f of element i is (f + 1)/4 - 3 i/8.
constexpr double sum_of_cx = 0.25 - 0.125 - 0.5, sum_of_px = 0.25 - 0.125;

INSTANTIATE_TEST_SUITE_P(
    Sums, Grammar,
    testing::Values(Reading{"sum(blobs, cx)", sum_of_cx}, Reading{"sum(blobs, 1)", 3},
                    Reading{"sum(links, px) - 1", sum_of_px - 1},
                    Reading{"sum(blobs, cx*b)", sum_of_cx* b},
                    Reading{"2*sum(blobs, cx) + sum(links, px)", 2 * sum_of_cx + sum_of_px},
                    Reading{"sum(blobs, cx*sum(links, px))", sum_of_cx* sum_of_px},
                    Reading{"sum(blobs, sum(links, cx + px))", 2 * sum_of_cx + 3 * sum_of_px},
                    // A field with one value for all elements is a parameter.
                    Reading{"sum(links, width)", 0.25}, Reading{"width", 0.125}));

TEST(ParserScope, InnermostNameWins) {
    Vocabulary v = test_vocabulary();
    v.parameters.push_back("px");
    v.arrays[0].fields.push_back({"px", {}});
    Bindings<double> bindings = test_bindings(2, 3);
    bindings.parameters.push_back(1000);
    bindings.arrays[0].fields.push_back({20, 30});
    bindings.arrays[1].fields[0] = {1, 2, 3};
    const auto value = [&](std::string_view text) {
        Graph graph;
        const NodeId root = parse(text, v, graph);
        return value_of(graph, root, {}, bindings);
    };
    EXPECT_EQ(value("px"), 1000);
    EXPECT_EQ(value("sum(blobs, px)"), 50);
    EXPECT_EQ(value("sum(links, px)"), 6);
    EXPECT_EQ(value("sum(blobs, sum(links, px))"), 12);
    EXPECT_EQ(value("sum(links, sum(blobs, px))"), 150);
    EXPECT_EQ(value("sum(blobs, px*sum(links, px))"), 300);
    // Fields are nearer than definitions, definitions nearer than parameters.
    EXPECT_EQ(value("px = 5; px + sum(blobs, px)"), 55);
    // A definition is read where it stands, not where it is used.
    EXPECT_EQ(value("q = px; sum(blobs, q)"), 2000);
}

TEST(ParserScope, ASumEndsItsNames) {
    EXPECT_THROW(value_of("sum(blobs, cx) + cx"), ParseError);
    EXPECT_THROW(value_of("q = sum(blobs, cx); sum(links, cx)"), ParseError);
    EXPECT_EQ(value_of("sum(blobs, cx) + sum(blobs, cx)"), 2 * sum_of_cx);
}

TEST(ParserScope, RandomIsForAnimation) {
    Vocabulary v;
    v.inputs = {"t", "i", "n"};
    v.allows_random = true;
    Graph graph;
    const NodeId root = parse("random(i, 2) + 0*t", v, graph);
    Bindings<double> bindings;
    bindings.seed = 42;
    EXPECT_EQ(value_of(graph, root, {0.5, 7, 9}, bindings), random_unit(42, 7, 2));
}

TEST(ParserScope, ReservedNames) {
    for (const auto* name : {"x", "y", "z", "pi", "sum", "min", "pow", "chebyshev", "random", "sin",
                             "floor", "tanh"}) {
        EXPECT_TRUE(is_reserved(name)) << name;
    }
    for (const auto* name : {"t", "a", "X", "Pi", "sine", "", "e"}) {
        EXPECT_FALSE(is_reserved(name)) << name;
    }
}

} // namespace
} // namespace isomotion::formula
