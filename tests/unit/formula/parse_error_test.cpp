#include "testing.h"

namespace isomotion::formula {
namespace {

using testing::HasSubstr;

ParseError error_of(std::string_view text, const Vocabulary& vocabulary = test_vocabulary()) {
    try {
        Graph graph;
        parse(text, vocabulary, graph);
    } catch (const ParseError& error) {
        return error;
    }
    ADD_FAILURE() << "no error: " << text;
    return {text, 0, "none"};
}

struct Mistake {
    std::string text;
    std::string message; // a part of it
    int column;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.text; }

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreNamedWithTheirPlace) {
    const auto& [text, message, column] = GetParam();
    const ParseError error = error_of(text);
    EXPECT_THAT(error.message(), HasSubstr(message));
    EXPECT_EQ(error.line(), 1);
    EXPECT_EQ(error.column(), column);
    // The caret stands below the place: four blanks, then the line.
    EXPECT_EQ(error.what(), error.message() + "\n    " + text + "\n" +
                                std::string(std::size_t(3 + column), ' ') + "^");
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, Mistakes,
    testing::Values(Mistake{"", "the formula ends where a value is expected", 1},
                    Mistake{"x + ", "the formula ends where a value is expected", 5},
                    Mistake{"x*(y+", "the formula ends where a value is expected", 6},
                    Mistake{"(x", "expected ')' to close the parenthesis", 3},
                    Mistake{"x)", "this ')' closes nothing", 2},
                    Mistake{"()", "expected a value before ')'", 2},
                    Mistake{"min(x,)", "expected a value before ')'", 7},
                    Mistake{"x + * y", "unexpected '*'", 5},
                    Mistake{"x; y", "unexpected ';': it stands behind definitions", 2},
                    Mistake{"x - 1,5", "unexpected ',': numbers are written with a point", 6},
                    Mistake{"x, y", "unexpected ','", 2},
                    Mistake{"x 2", "expected an operator before '2'", 3},
                    Mistake{"(x)2", "expected an operator before '2'", 4},
                    Mistake{"1.5e", "the exponent of a number has no digits", 4},
                    Mistake{"1/2x", "after a quotient: write a/(b*c), or (a/b)*c", 4},
                    Mistake{"x/2(y)", "after a quotient", 4},
                    Mistake{"sin x", "sin needs parentheses: write 'sin(a)'", 1},
                    Mistake{"2 sum", "sum needs parentheses", 3},
                    Mistake{"arg(x, y)", "write atan2(y, x)", 1},
                    Mistake{"atan(y, x)", "atan takes 1 argument, not 2: write atan2(y, x)", 1},
                    Mistake{"theta + x", "write atan2(y, x)", 1},
                    Mistake{"x + mod(y)", "mod takes 2 arguments, not 1", 5},
                    Mistake{"if(x > 0, y)", "if takes 3 arguments, not 2", 1},
                    Mistake{"x > 0 ? y", "expected ':' between the two values of a choice", 10},
                    Mistake{"x == 0 == y", "one '=' at most", 8},
                    Mistake{"2 + round x", "round needs parentheses: write 'round(a)'", 5},
                    Mistake{"x % 2", "unexpected '%': write mod(a, b) for the rest", 3},
                    Mistake{"|x", "expected '|' to close the absolute value", 3},
                    Mistake{"|x)", "expected '|' to close the absolute value", 3},
                    Mistake{"(|x)|", "expected '|' to close the absolute value", 4},
                    Mistake{"x^{2", "expected '}' to close the exponent", 5},
                    Mistake{"x⁻", "expected raised digits after the raised minus", 2},
                    Mistake{"0⁻¹", "division by zero: 0 to a negative power", 2},
                    Mistake{"x $ y", "unexpected '$'", 3},
                    Mistake{"x^", "the formula ends where a value is expected", 3},
                    Mistake{"1 + xa", "unknown name 'xa'; a product is written 'x*a'", 5},
                    Mistake{"zya", "a product is written 'z*y*a'", 1},
                    Mistake{"xw", "unknown name 'xw'; did you mean 'x'?", 1},
                    Mistake{"A", "unknown name 'A'; did you mean 'a'?", 1}));

INSTANTIATE_TEST_SUITE_P(Numbers, Mistakes,
                         testing::Values(Mistake{"1e999*x", "this number is out of range", 1},
                                         Mistake{"x+.", "this is not a number", 3},
                                         Mistake{"1.2.3", "unexpected '.'", 4}));

INSTANTIATE_TEST_SUITE_P(Equations, Mistakes,
                         testing::Values(Mistake{"x^2 = 1 = y", "one '=' at most", 9},
                                         Mistake{"x = = y", "unexpected '='", 5},
                                         Mistake{"x =", "ends where a value is expected", 4},
                                         Mistake{"= x", "a value is expected before '='", 1},
                                         Mistake{"q = 2", "unknown name 'q'", 1},
                                         Mistake{"q = 2 x; r = 2 ; q = r = 1", "one '='", 24},
                                         Mistake{"pi = 3; x", "'pi' already has a meaning", 1},
                                         Mistake{"y = 3; x", "'y' already has a meaning", 1},
                                         Mistake{" max = 3; x", "'max' already has a meaning", 2},
                                         Mistake{"q = q; x", "unknown name 'q'", 5}));

INSTANTIATE_TEST_SUITE_P(
    Names, Mistakes,
    testing::Values(Mistake{"x + q", "unknown name 'q'; known: x, y, z, a, b, c, m, width, pi", 5},
                    Mistake{"widht*x", "unknown name 'widht'; did you mean 'width'?", 1},
                    Mistake{"speed = 1; sped", "did you mean 'speed'?", 12},
                    Mistake{"x + cx", "'cx' is a field of the array 'blobs'", 5},
                    Mistake{"sum(links, cx)", "has a value only inside sum(blobs, ...)", 12},
                    Mistake{"sum(blobs, wieght)", "did you mean 'weight'?", 12},
                    Mistake{"sqr(x)", "there is no function 'sqr'; write a^2", 1},
                    Mistake{"1+foobar(x)", "there is no function 'foobar'", 3}));

INSTANTIATE_TEST_SUITE_P(
    Calls, Mistakes,
    testing::Values(Mistake{"sin()", "sin takes 1 argument, not 0", 1},
                    Mistake{"x+sin(x, y)", "sin takes 1 argument, not 2", 3},
                    Mistake{"pow(x)", "pow takes 2 arguments, not 1", 1},
                    Mistake{"min(x)", "min takes two or more", 1},
                    Mistake{"max()", "max takes two or more", 1},
                    Mistake{"sin(x", "expected ')' to close the argument list", 6},
                    Mistake{"random(1, 2)", "random is for animation", 1},
                    Mistake{"chebyshev(x, y)", "must be a constant integer from 0 to 1000", 11},
                    Mistake{"chebyshev(2.5, y)", "must be a constant integer", 11},
                    Mistake{"chebyshev(-1, y)", "must be a constant integer", 11},
                    Mistake{"chebyshev(1001, y)", "must be a constant integer", 11},
                    Mistake{"chebyshev(3)", "between the degree and the argument", 12},
                    Mistake{"chebyshev(3, x, y)", "to close the argument list", 15}));

INSTANTIATE_TEST_SUITE_P(
    Sums, Mistakes,
    testing::Values(
        Mistake{"sum(blob, 1)", "no array 'blob'; did you mean 'blobs'?", 5},
        Mistake{"sum(stars, 1)", "no array 'stars'; known: blobs, links", 5},
        Mistake{"sum(blobs)", "expected ',' between the array and the expression", 10},
        Mistake{"sum(blobs, 1", "expected ')' to close the sum", 13},
        Mistake{"sum(blobs, 1, 2)", "expected ')' to close the sum", 13},
        Mistake{"sum(blobs, sum(links, sum(blobs, 1)))",
                "a sum over 'blobs' inside a sum over 'blobs'", 23},
        Mistake{"sum(blobs, least(blobs, 1))", "a least over 'blobs' inside a sum over 'blobs'",
                12},
        Mistake{"least(blob, 1)", "least(array, expression): there is no array 'blob'", 7},
        Mistake{"greatest(blobs)", "expected ',' between the array and the expression of greatest",
                15},
        Mistake{"least(blobs, 1, 2, 3)", "expected ')' to close the least", 18},
        Mistake{"least(blobs, 1) + cx", "has a value only inside sum(blobs, ...)", 19}));

// What has no value, or none a shader could hold.
INSTANTIATE_TEST_SUITE_P(
    Values, Mistakes,
    testing::Values(Mistake{"x/0", "division by zero", 2},
                    Mistake{"x / (1 - 1)", "division by zero", 3},
                    Mistake{"x/(a - a)", "division by zero", 2},
                    Mistake{"0^-1", "division by zero: 0 to a negative power", 2},
                    Mistake{"(-2)^0.5", "no real power with a fractional exponent", 5},
                    Mistake{"pow(-8, 1/3)", "no real power with a fractional exponent", 1},
                    Mistake{"log(-1)", "log is not defined here", 5},
                    Mistake{"1e308*10*x", "beyond the range of numbers", 6},
                    Mistake{"x + 1e308*1e308*0", "beyond the range of numbers", 10},
                    Mistake{"1e308 + 1e308", "beyond the range of numbers", 7},
                    Mistake{"-1e308 - 1e308", "beyond the range of numbers", 8}));

TEST(ParseErrorPlace, NoArrays) {
    Vocabulary v;
    v.inputs = coordinate_names;
    EXPECT_THAT(error_of("sum(blobs, 1)", v).message(), HasSubstr("the scene has none"));
}

TEST(ParseErrorPlace, AnExpressionIsNoEquation) {
    Vocabulary v;
    v.inputs = {"t"};
    EXPECT_THAT(error_of("t = 1", v).message(), HasSubstr("expected ';' after the definition"));
    EXPECT_THAT(error_of("2 + t = 1", v).message(), HasSubstr("unexpected '='"));
}

TEST(ParseErrorPlace, LinesAndColumns) {
    const ParseError error = error_of("q = x + y;\n\n  q*q - foo\n + 1");
    EXPECT_EQ(error.line(), 3);
    EXPECT_EQ(error.column(), 9);
    EXPECT_THAT(error.what(), HasSubstr("\n      q*q - foo\n            ^"));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("+ 1")));
}

TEST(ParseErrorPlace, TheEndOfAFormulaOfLines) {
    const ParseError error = error_of("x +\ny +\n");
    EXPECT_EQ(error.line(), 3);
    EXPECT_EQ(error.column(), 1);
}

TEST(ParseErrorPlace, AWholeCharacterIsShown) {
    const ParseError error = error_of("x ± y");
    EXPECT_EQ(error.message(), "unexpected '±'");
    EXPECT_EQ(error.column(), 3);
    EXPECT_EQ(error_of("\xff").message(), "unexpected '\xff'");
    EXPECT_EQ(error_of(std::string("x\0", 2)).column(), 2);
}

TEST(ParseErrorPlace, ColumnsCountCharacters) {
    const ParseError error("αβγ + δ", std::string_view("αβγ + ").size(), "here");
    EXPECT_EQ(error.column(), 7);
    EXPECT_STREQ(error.what(), "here\n    αβγ + δ\n          ^");
}

// The characters of `text`, each as its UTF-8 bytes; fails on broken ones.
std::vector<std::string> characters(std::string_view text) {
    std::vector<std::string> result;
    for (const char byte : text) {
        const bool continues = (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
        if (continues && result.empty()) ADD_FAILURE() << "begins inside a character";
        if (!continues || result.empty()) result.emplace_back();
        result.back() += byte;
    }
    for (const auto& character : result) {
        const auto lead = static_cast<unsigned char>(character[0]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        EXPECT_EQ(character.size(), length) << "a cut character in " << text;
    }
    return result;
}

// Whatever surrounds the place, the caret points at it and the line stays readable.
TEST(ParseErrorPlace, LongLinesAreCutAroundThePlace) {
    for (const std::string filler : {"+", "é", "−", "🌀"}) {
        for (const int before : {0, 10, 59, 60, 63, 64, 65, 100, 5000}) {
            for (const int after : {0, 10, 31, 100, 5000}) {
                SCOPED_TRACE(testing::Message() << filler << ' ' << before << ' ' << after);
                std::string text;
                for (int k = 0; k < before; ++k) text += filler;
                const std::size_t place = text.size();
                text += "X";
                for (int k = 0; k < after; ++k) text += filler;

                const ParseError error(text, place, "message");
                EXPECT_EQ(error.column(), before + 1);
                const std::string what = error.what();
                const auto first = what.find('\n'), second = what.find('\n', first + 1);
                const auto line = characters(what.substr(first + 1, second - first - 1));
                const std::string caret = what.substr(second + 1);
                EXPECT_EQ(caret.find_first_not_of(' '), caret.size() - 1);
                ASSERT_LE(caret.size(), line.size());
                EXPECT_EQ(line[caret.size() - 1], "X");
                EXPECT_LE(line.size(), 110u);
            }
        }
    }
}

} // namespace
} // namespace isomotion::formula
