#include "testing.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "formula/field.h"
#include "formula/glsl/glsl.h"
#include "random_formula.h"

namespace isomotion::formula {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string glsl(std::string_view text) { return glsl_value(make_field(text, test_vocabulary())); }

TEST(Glsl, APolynomial) {
    EXPECT_EQ(glsl("x^2 + y^2 - (1-z)*z^2 + a"), R"(float field(vec3 p) {
    float v1 = p.x * p.x;
    float v3 = p.y * p.y;
    float v4 = v1 + v3;
    float v7 = 1.0 - p.z;
    float v8 = p.z * p.z;
    float v9 = v7 * v8;
    float v10 = v4 - v9;
    float v12 = v10 + parameters[0].x;
    return float(v12);
}
)");
}

TEST(Glsl, TheSlopeAlongTheRay) {
    EXPECT_EQ(glsl_directional(make_field("sin(x)*y", test_vocabulary())),
              R"(vec2 field_directional(vec3 p, vec3 d) {
    vec2 w1 = im_sin_cos(p.x);
    float v3 = w1.x * p.y;
    float v7 = d.x * w1.y;
    float v8 = w1.x * d.y;
    float v9 = p.y * v7;
    float v10 = v8 + v9;
    return vec2(v3, v10);
}
)");
}

// A value and its slope share a kernel where one gives both, in whatever order they come.
TEST(Glsl, PowersThatDifferByOneShareAKernel) {
    for (const auto* text : {"abs(x)^2.5 + abs(x)^1.5", "abs(x)^1.5 + abs(x)^2.5",
                             "abs(x)^a + abs(x)^(a-1)", "abs(x)^(a-1) + abs(x)^a"}) {
        const std::string code = glsl(text);
        EXPECT_THAT(code, HasSubstr("im_pow_and_lower(")) << text;
        EXPECT_THAT(code, Not(HasSubstr("im_pow("))) << text;
    }
    EXPECT_THAT(glsl_directional(make_field("abs(x)^a", test_vocabulary())),
                HasSubstr("im_pow_and_lower("));
    for (const auto* text : {"abs(x)^2.5 + abs(y)^1.5", "abs(x)^a + abs(x)^(a-2)",
                             "abs(x)^a + abs(x)^(b-1)", "abs(x)^a + abs(x)^(1-a)"}) {
        EXPECT_THAT(glsl(text), Not(HasSubstr("im_pow_and_lower("))) << text;
    }
}

// Six fields need two texels; what no element changes stands before the loop.
TEST(Glsl, ASumOverSixFields) {
    EXPECT_EQ(glsl("sum(blobs, weight*exp(-s*(r + (x-cx)^2+(y-cy)^2+(z-cz)^2)) + sqrt(c)) - b"),
              R"(float field(vec3 p) {
    float v4 = im_sqrt(parameters[0].z);
    float v6 = 0.0;
    for (int e0 = 0; e0 < array0_count; ++e0) {
        vec4 a0_0 = array0_texel(e0, 0);
        vec4 a0_1 = array0_texel(e0, 1);
        float v11 = p.x - a0_0.x;
        float v12 = v11 * v11;
        float v13 = a0_1.x + v12;
        float v15 = p.y - a0_0.y;
        float v16 = v15 * v15;
        float v17 = v13 + v16;
        float v19 = p.z - a0_0.z;
        float v20 = v19 * v19;
        float v21 = v17 + v20;
        float v22 = a0_1.y * v21;
        float v23 = -v22;
        float v24 = im_exp(v23);
        float v25 = a0_0.w * v24;
        float v26 = v4 + v25;
        v6 += v26;
    }
    float v27 = v6 - parameters[0].y;
    return float(v27);
}
)");
}

TEST(Glsl, NestedLoopsHaveTheirOwnNames) {
    const std::string text = glsl("sum(blobs, sum(links, max(cx, py)))");
    EXPECT_THAT(text, HasSubstr("for (int e0 = 0; e0 < array0_count; ++e0) {"));
    EXPECT_THAT(text, HasSubstr("for (int e1 = 0; e1 < array1_count; ++e1) {"));
    EXPECT_THAT(text, HasSubstr("vec4 a0_0 = array0_texel(e0, 0);"));
    EXPECT_THAT(text, HasSubstr("vec4 a1_0 = array1_texel(e1, 0);"));
    // Only py of links is read, so it is packed first.
    EXPECT_THAT(text, HasSubstr("max(a0_0.x, a1_0.x)"));
}

TEST(Glsl, OnlyTexelsThatAreUsedAreRead) {
    const Field field = make_field("sum(blobs, cx+cy+cz+weight+r*x+s)", test_vocabulary());
    EXPECT_THAT(glsl_value(field), HasSubstr("array0_texel(e0, 1)"));
    // The slope needs r alone: it lies in the second texel of the same storage.
    EXPECT_THAT(glsl_gradient(field), HasSubstr("a0_1.x"));
    EXPECT_THAT(glsl_gradient(field), Not(HasSubstr("array0_texel(e0, 0)")));
    // The fifth and sixth field alone lie first.
    EXPECT_THAT(glsl("sum(blobs, r*s)"), HasSubstr("a0_0.x * a0_0.y"));
    EXPECT_THAT(glsl("sum(blobs, r*s)"), Not(HasSubstr("array0_texel(e0, 1)")));
}

// The text is a function of the formula: nothing about values or counts is even passed in, and the
// names of parameters don't show either.
TEST(Glsl, TextDependsOnTheFormulaAlone) {
    const auto* text = "sum(blobs, weight*exp(-s*((x-cx)^2+(y-cy)^2))) - a*z^2 + b";
    EXPECT_EQ(glsl(text), glsl(text));
    EXPECT_THAT(glsl(text), HasSubstr("parameters[0].x"));
    EXPECT_THAT(glsl(text), HasSubstr("parameters[0].y"));

    Vocabulary renamed = test_vocabulary();
    renamed.parameters = {"one", "two", "three", "four", "width"};
    EXPECT_EQ(glsl_value(make_field(
                  "sum(blobs, weight*exp(-s*((x-cx)^2+(y-cy)^2))) - one*z^2 + two", renamed)),
              glsl(text));
}

// Counts are read by the shader: a sum is one loop whatever the array holds, and two sums over one
// array are still that loop.
TEST(Glsl, ASumIsALoop) {
    const std::string text = glsl("sum(blobs, cx*x) + sum(blobs, cy*y)");
    EXPECT_THAT(text, HasSubstr("e0 < array0_count"));
    EXPECT_EQ(text.find("for ("), text.rfind("for ("));
    EXPECT_EQ(std::count(text.begin(), text.end(), '*'), 2);
}

TEST(Glsl, ConstantFields) {
    EXPECT_EQ(glsl("7"), "float field(vec3 p) {\n    return float(7.0);\n}\n");
    EXPECT_EQ(glsl("-7"), "float field(vec3 p) {\n    return float(-7.0);\n}\n");
    EXPECT_EQ(glsl("x"), "float field(vec3 p) {\n    return float(p.x);\n}\n");
    EXPECT_EQ(glsl_gradient(make_field("2*x-z", test_vocabulary())),
              "vec3 field_gradient(vec3 p) {\n    return vec3(2.0, 0.0, -1.0);\n}\n");
}

// "--" is an operator in GLSL, and "x - -1" is easily written without the blank.
TEST(Glsl, NegativeOperandsNeverMakeADecrement) {
    for (const auto* text : {"x - -1", "x - -y", "-(-1)*x - -2", "x*-1.5 - -2*y", "min(-1, -x)",
                             "-exp(-x) - -3", "-(-x*-1.5)", "-(-2)^x", "sum(blobs, -2*cx - -1)",
                             "-1/x", "-2 - x", "max(x,-1) - min(y,-1)"}) {
        const Field field = make_field(text, test_vocabulary());
        for (const auto& code :
             {glsl_value(field), glsl_directional(field), glsl_gradient(field)}) {
            EXPECT_THAT(code, Not(HasSubstr("--"))) << text;
            EXPECT_THAT(code, Not(HasSubstr("nan"))) << text;
            EXPECT_THAT(code, Not(HasSubstr("inf"))) << text;
        }
    }
    EXPECT_THAT(glsl("x - -1"), HasSubstr("p.x - (-1.0)"));
}

double read_back(const std::string& literal) {
    float value = 0;
    const auto [end, error] =
        std::from_chars(literal.data(), literal.data() + literal.size(), value);
    EXPECT_EQ(error, std::errc{}) << literal;
    EXPECT_EQ(end, literal.data() + literal.size()) << literal;
    return value;
}

TEST(GlslLiteral, ReadsBackToTheNearestFloat) {
    for (const double value : {0.0,        1.0,         -1.0,  0.1,    -0.1,  1.0 / 3,
                               1e30,       -1e30,       1e-30, 3.4e38, 1e-45, 1.17549435e-38,
                               16777217.0, 123456789.0, 1e10,  1e16,   1e17,  3.14159265358979,
                               5e-324,     65504.0}) {
        const std::string text = glsl_literal(value);
        EXPECT_EQ(read_back(text), double(float(value))) << text;
        // Without a point or an exponent it would be an int, and int*float doesn't compile in ES.
        EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text;
        EXPECT_EQ(text.find_first_not_of("+-.e0123456789"), std::string::npos) << text;
    }
    EXPECT_TRUE(std::signbit(read_back(glsl_literal(-0.0))));
}

TEST(GlslLiteral, RandomFloats) {
    constexpr std::uint64_t seed = 50;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 20'000; ++k) {
        const double value = std::ldexp(random.in(-1, 1), random.below(270) - 145);
        ASSERT_EQ(read_back(glsl_literal(value)), double(float(value))) << value;
    }
}

TEST(GlslLiteral, WhatFloatCannotHoldIsItsLargest) {
    constexpr double largest = std::numeric_limits<float>::max();
    EXPECT_EQ(read_back(glsl_literal(1e39)), largest);
    EXPECT_EQ(read_back(glsl_literal(-1e300)), -largest);
    EXPECT_EQ(read_back(glsl_literal(std::numeric_limits<double>::infinity())), largest);
}

// Whole numbers as they are written, everything else by its bits.
TEST(GlslLiteral, DoublesHaveTheBitsOfTheirValue) {
    EXPECT_EQ(glsl_double_literal(0), "0.0lf");
    EXPECT_EQ(glsl_double_literal(3), "3.0lf");
    EXPECT_EQ(glsl_double_literal(0.1), "packDouble2x32(uvec2(0x9999999au, 0x3fb99999u))");
    EXPECT_EQ(glsl_double_literal(-0.0), "packDouble2x32(uvec2(0x00000000u, 0x80000000u))");
    constexpr std::uint64_t seed = 51;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 1000; ++k) {
        const double value = std::ldexp(random.in(-1, 1), random.below(2000) - 1000);
        const std::string text = glsl_double_literal(value);
        unsigned low = 0, high = 0;
        ASSERT_EQ(std::sscanf(text.c_str(), "packDouble2x32(uvec2(%xu, %xu))", &low, &high), 2)
            << text;
        ASSERT_EQ(std::bit_cast<double>(std::uint64_t{high} << 32 | low), value) << text;
    }
}

TEST(Glsl, ParametersArePackedByFour) {
    EXPECT_EQ(glsl_parameter(0), "parameters[0].x");
    EXPECT_EQ(glsl_parameter(3), "parameters[0].w");
    EXPECT_EQ(glsl_parameter(4), "parameters[1].x");
    EXPECT_EQ(glsl_parameter(9), "parameters[2].y");
}

TEST(Glsl, KernelsAreTheOnesTheTextCalls) {
    const auto kernels = [](std::string_view text) {
        return kernels_used(make_field(text, test_vocabulary()).value);
    };
    using Set = std::set<std::string>;
    EXPECT_EQ(kernels("x^2+y*z-abs(x)+min(x,floor(y))-sign(z)"), Set{});
    EXPECT_EQ(kernels("exp(x)/y"), (Set{"exp", "divide"}));
    EXPECT_EQ(kernels("sum(blobs, x^cx) + sqrt(y)"), (Set{"pow", "sqrt"}));
    EXPECT_EQ(kernels("x^-3"), Set{"divide"});
    EXPECT_EQ(kernels("sin(x)+cos(x)+tan(x)+sinh(x)+cosh(x)+tanh(x)+asin(x)+acos(x)+atan(x)+log(x)+"
                      "atan2(y,x)+asinh(x)+acosh(x)+erf(x)+cbrt(x)"),
              (Set{"sin", "cos", "tan", "sinh", "cosh", "tanh", "asin", "acos", "atan", "atan2",
                   "log", "asinh", "acosh", "erf", "cbrt"}));
    for (const auto* text : {"exp(x)/y", "sum(blobs, x^cx)+sqrt(y)", "tanh(x)*acos(y)"}) {
        const std::string code = glsl(text);
        for (const auto& kernel : kernels(text)) {
            EXPECT_THAT(code, HasSubstr("im_" + kernel + "(")) << text;
        }
    }
}

// Reads what the writer wrote: every name is declared once in an open block before it is used.
void expect_well_formed(const std::string& code) {
    SCOPED_TRACE(code);
    std::vector<std::set<std::string>> blocks{{}};
    const auto known = [&](const std::string& name) {
        return std::any_of(blocks.begin(), blocks.end(),
                           [&](const auto& block) { return block.contains(name); });
    };
    std::size_t at = 0;
    std::string before;
    while (at < code.size()) {
        if (code[at] == '{') blocks.emplace_back();
        if (code[at] == '}') blocks.pop_back();
        std::size_t end = at;
        while (end < code.size() &&
               (std::isalnum(static_cast<unsigned char>(code[end])) != 0 || code[end] == '_')) {
            ++end;
        }
        if (end == at) {
            ++at;
            continue;
        }
        const std::string word = code.substr(at, end - at);
        const bool ours = (word[0] == 'v' || word[0] == 'a') && word.size() > 1 &&
                          std::isdigit(static_cast<unsigned char>(word[1])) != 0;
        const bool declared =
            at > 0 && code[at - 1] == ' ' && (before == "float" || before == "vec4");
        if (ours && declared) {
            EXPECT_TRUE(blocks.back().insert(word).second) << word << " is declared twice";
        } else if (ours) {
            EXPECT_TRUE(known(word)) << word << " is not declared";
        }
        before = word;
        at = end;
    }
    EXPECT_EQ(blocks.size(), 1u);
}

TEST(Glsl, RandomFormulasAreWellFormed) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const std::string text = FormulaGenerator(seed).make(2 + int(seed % 4)).text;
        const Field field = make_field(text, test_vocabulary());
        for (const auto& code :
             {glsl_value(field), glsl_directional(field), glsl_gradient(field)}) {
            expect_well_formed(code);
        }
        if (HasFailure()) return;
    }
}

} // namespace
} // namespace isomotion::formula
