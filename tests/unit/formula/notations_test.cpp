// Formulas as other programs and books write them.
#include <string>

#include "formula/graph/parser.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

using testing::HasSubstr;

struct Notation {
    std::string written, plain;
};

void PrintTo(const Notation& notation, std::ostream* out) { *out << notation.written; }

class Notations : public testing::TestWithParam<Notation> {};

// Equal expressions are one node of a graph.
TEST_P(Notations, AreReadAsWhatTheyMean) {
    const auto& [written, plain] = GetParam();
    Graph graph;
    EXPECT_EQ(parse(written, test_vocabulary(), graph), parse(plain, test_vocabulary(), graph));
}

INSTANTIATE_TEST_SUITE_P(
    Signs, Notations,
    testing::Values(Notation{"x == y", "x = y"}, Notation{"x**2", "x^2"}, Notation{"x .^ 2", "x^2"},
                    Notation{"2**3**2", "2^3^2"}, Notation{"-x**2", "-x^2"},
                    Notation{"x.*y./z", "x*y/z"}, Notation{"x·y", "x*y"},
                    Notation{"x×y÷z", "x*y/z"}, Notation{"x−y", "x - y"},
                    Notation{"x³ + y⁻²", "x^3 + y^(-2)"}, Notation{"9/4 y²", "(9/4)*y^2"},
                    Notation{"(x² + 9/4 y² + z² − 1)³ − x²z³ − 9/80 y²z³ = 0",
                             "(x^2 + (9/4)*y^2 + z^2 - 1)^3 - x^2*z^3 - (9/80)*y^2*z^3 = 0"},
                    Notation{"1/2 x y", "(1/2)*x*y"}, Notation{"9/4\\,y", "(9/4)*y"},
                    Notation{"z = 1||x| - y|", "z = 1*abs(abs(x) - y)"}, Notation{"½x", "0.5*x"},
                    Notation{"√2 x", "sqrt(2)*x"}, Notation{"2√(x + y)", "2*sqrt(x + y)"},
                    Notation{"∛(x)", "cbrt(x)"}, Notation{"[x + y]*2", "(x + y)*2"},
                    Notation{"1.5f*x", "1.5*x"}, Notation{"x + y;", "x + y"},
                    Notation{"x\u00a0y", "x*y"}, Notation{"||x| - 1|", "abs(abs(x) - 1)"},
                    Notation{"2||x| - y|", "2*abs(abs(x) - y)"}, Notation{"x ≤ 1", "x <= 1"},
                    Notation{"if x == y then 1 else z", "if(x == y, 1, z)"},
                    Notation{"if (x < 0) then y else z", "if(x < 0, y, z)"},
                    Notation{"(x ≠ y) + z", "(x < y or y < x) + z"},
                    Notation{"(x != y) + z", "(x < y or y < x) + z"},
                    Notation{"if(x == y, 1, z)", "if(x <= y and y <= x, 1, z)"},
                    Notation{"x < 0 || y < z", "x < 0 or y < z"},
                    Notation{"(x < 0)||(y < 0)", "x < 0 or y < 0"},
                    Notation{"!(x < 0) ∧ y < 0", "not (x < 0) and y < 0"}));

INSTANTIATE_TEST_SUITE_P(
    Names, Notations,
    testing::Values(
        Notation{"X^2 + Y*Z", "x^2 + y*z"}, Notation{"2xyz + xy^2", "2*x*y*z + x*y^2"},
        Notation{"cos(Pi*x)", "cos(pi*x)"}, Notation{"sin(PI*x)", "sin(pi*x)"},
        Notation{"E^x", "exp(x)"}, Notation{"e**x", "exp(x)"}, Notation{"Sin[x]", "sin(x)"},
        Notation{"Sqrt[Abs[x]] + Cos[y z]", "sqrt(abs(x)) + cos(y*z)"},
        Notation{"Power[x, 2]", "x^2"}, Notation{"If[x > 0, y, z]", "if(x > 0, y, z)"},
        Notation{"np.sin(x)*np.pi", "sin(x)*pi"}, Notation{"numpy.maximum(x, y)", "max(x, y)"},
        Notation{"math.sqrt(x)", "sqrt(x)"}, Notation{"Math.pow(x, 2)", "x^2"},
        Notation{"std::abs(x)", "abs(x)"}, Notation{"np.where(x < y, 1, z)", "if(x < y, 1, z)"},
        Notation{"if x < y then 1 else z", "if(x < y, 1, z)"},
        Notation{"tg(x) + ctg(y)", "tan(x) + cot(y)"}, Notation{"sgn(x)", "sign(x)"},
        Notation{"artanh(x/9)", "atanh(x/9)"}, Notation{"fabs(x)", "abs(x)"},
        Notation{"log_2(x)", "log2(x)"}, Notation{"sin^2(x) + cos²(y)", "sin(x)^2 + cos(y)^2"},
        Notation{"sin^{3}(x)", "sin(x)^3"}, Notation{"f(x, y, z) = x^2 + y - 1", "x^2 + y - 1"}));

INSTANTIATE_TEST_SUITE_P(
    Latex, Notations,
    testing::Values(Notation{"\\frac{x}{2}", "x/2"}, Notation{"\\dfrac{x + y}{z}", "(x + y)/z"},
                    Notation{"\\sqrt{x^2 + y^{2}}", "sqrt(x^2 + y^2)"},
                    Notation{"\\sqrt[3]{x}", "cbrt(x)"},
                    Notation{"\\left(x + y\\right) z", "(x + y)*z"},
                    Notation{"2 \\cdot x \\times y", "2*x*y"},
                    Notation{"\\sin(\\pi x) + \\cos^2(y)", "sin(pi*x) + cos(y)^2"},
                    Notation{"\\left|x\\right| \\le 1", "abs(x) <= 1"},
                    Notation{"\\operatorname{sign}(x)\\,y", "sign(x)*y"},
                    Notation{"\\mathrm{sin}(x)", "sin(x)"}));

INSTANTIATE_TEST_SUITE_P(
    Vectors, Notations,
    testing::Values(Notation{"length(p)", "length(x, y, z)"},
                    Notation{"length(p.xy)", "length(x, y)"},
                    Notation{"length(vec3(x, y, z - 1))", "length(x, y, z - 1)"},
                    Notation{"length(vec2(length(p.xy) - 2, p.z)) - 1",
                             "length(length(x, y) - 2, z) - 1"},
                    Notation{"dot(p, p)", "x*x + y*y + z*z"},
                    Notation{"dot(p, vec3(1, 2, 3))", "x + 2*y + 3*z"}, Notation{"p.x^2", "x^2"}));

struct Refused {
    std::string text, words;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.text; }

class RefusedNotations : public testing::TestWithParam<Refused> {};

// What may mean two things, or nothing, is answered by what to write.
TEST_P(RefusedNotations, AreToldWhatToWrite) {
    Graph graph;
    try {
        parse(GetParam().text, test_vocabulary(), graph);
        FAIL() << "no error";
    } catch (const ParseError& error) {
        EXPECT_THAT(error.message(), HasSubstr(GetParam().words));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Unclear, RefusedNotations,
    testing::Values(Refused{"sin x", "sin needs parentheses: write 'sin(a)'"},
                    Refused{"sin^2 x", "sin needs parentheses"},
                    Refused{"sin^-1(x)", "write 1/sin(a), or the inverse"},
                    Refused{"sin⁻¹(x)", "write 1/sin(a), or the inverse"},
                    Refused{"√x²", "write √(a^2), or (√a)^2"},
                    Refused{"1/2x", "write a/(b*c), or (a/b)*c"}, Refused{"2^xy", "write (x*y)"},
                    Refused{"√xy", "write (x*y)"}, Refused{"e^-xy", "write (x*y)"},
                    Refused{"x == 1 ? y : z", "put the comparison in parentheses"},
                    Refused{"x == 1 and y > 0", "put the comparison in parentheses"},
                    Refused{"y > 0 and x == 1", "put the comparison in parentheses"},
                    Refused{"x != 1", "put the comparison in parentheses"},
                    Refused{"2f(x) + y", "there is no function 'f'"},
                    Refused{"!x < y", "write !(a < b)"}, Refused{"frac(x)", "write fract(a)"},
                    Refused{"sqr(x)", "write a^2 for a square, sqrt(a) for a root"},
                    Refused{"Log[2, x]", "write log(a)/log(b)"}, Refused{"lg(x)", "write log10(a)"},
                    Refused{"fmod(x, 2)", "write mod(a, b)"}, Refused{"x % 2", "write mod(a, b)"},
                    Refused{"vec3(x, y, z)", "no vectors"}, Refused{"abs(p)", "write x, y and z"},
                    Refused{"rho - 1", "write length(x, y)"}, Refused{"phi", "write atan2(y, x)"},
                    Refused{"Piecewise[{{x, x > 0}}, y]", "write if(condition, a, b)"},
                    Refused{"φ + x", "Latin letters"}, Refused{"x^2 {x > 0}", "a condition"},
                    Refused{"dot(x, y, z)", "two vectors"},
                    Refused{"dot(p, p.xy)", "as many parts"},
                    Refused{"length(vec3(x, y))", "vec3 takes 3 parts, not 2"},
                    Refused{"length(p, x)", "one vector"}, Refused{"\\frac12 x", "\\frac{a}{b}"},
                    Refused{"if x > 0 then y", "expected 'else'"}));

// A name that a scene gives is that name, whatever it means elsewhere.
TEST(Notation, LeavesNamesOfTheScene) {
    Vocabulary vocabulary{coordinate_names, {"X", "p", "xy", "norm", "f", "then", "E"}, {}};
    Graph graph;
    EXPECT_EQ(parse("X", vocabulary, graph), graph.parameter(0));
    EXPECT_EQ(parse("p", vocabulary, graph), graph.parameter(1));
    EXPECT_EQ(parse("xy", vocabulary, graph), graph.parameter(2));
    EXPECT_EQ(parse("norm(x)", vocabulary, graph), parse("norm*x", vocabulary, graph));
    EXPECT_EQ(parse("2f", vocabulary, graph), parse("2*f", vocabulary, graph));
    EXPECT_EQ(parse("2 then", vocabulary, graph), parse("2*then", vocabulary, graph));
    EXPECT_EQ(parse("E^x", vocabulary, graph), parse("pow(E, x)", vocabulary, graph));
    EXPECT_EQ(parse("tg(u) = u^2; tg(x)", vocabulary, graph), parse("x^2", vocabulary, graph));
}

} // namespace
} // namespace isomotion::formula
