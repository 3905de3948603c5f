#include "shader/inlined_size.h"

#include <cstdlib>

#include <gmock/gmock.h>

#include "scenes.h"

namespace isomotion::shader {
namespace {

TEST(InlinedSize, CountsABodyAsOftenAsItIsCalled) {
    EXPECT_EQ(inlined_size(""), 0);
    EXPECT_EQ(inlined_size("void main() {\n    a = b + c; // - nothing\n}\n"), 2);
    const std::string twice = "float f(float x) {\n    return x * x;\n}\n"
                              "float g(float x) {\n    return f(x) + f(f(x));\n}\n"
                              "float unused(float x) {\n    return x / x / x;\n}\n";
    EXPECT_EQ(inlined_size(twice + "void main() {\n    y = g(x) - g(x);\n}\n"), 2 * 4 + 2);
    // Declarations and tables are no functions.
    EXPECT_EQ(inlined_size("layout(location = 0) out vec4 f;\nconst float t[2] = float[](\n"
                           "    1.0 + 1.0, 2.0);\nvoid main() {\n    y = sqrt(x);\n}\n"),
              1);
}

TEST(InlinedSize, OverloadsCountAsTheirMeanAndMayCallEachOther) {
    EXPECT_EQ(inlined_size("float f(float x) {\n    return x + x + x;\n}\n"
                           "vec2 f(vec2 x) {\n    return vec2(f(x.x) + f(x.y));\n}\n"
                           "void main() {\n    f(x); f(y);\n}\n"),
              2 * 1.5);
}

TEST(InlinedSize, BoundsOfTheFieldCountHalf) {
    const std::string body = "(vec2 x) {\n    return x * x + x;\n}\n";
    for (const std::string name : {"field_rough", "field_interval", "field_directional_interval"}) {
        EXPECT_EQ(inlined_size("vec2 " + name + body + "void main() {\n    " + name + "(p);\n}\n"),
                  1);
    }
}

TEST(InlinedSize, WavesCountTwoFifths) {
    EXPECT_DOUBLE_EQ(
        inlined_size("vec2 im_sin_cos(float x) {\n    return x + x + x + x + x + x;\n}\n"
                     "void main() {\n    im_sin_cos(p);\n}\n"),
        2);
}

TEST(InlinedSize, MarchesCountTwice) {
    EXPECT_DOUBLE_EQ(inlined_size("float march_part(float x) {\n    return x + x;\n}\n"
                                  "void main() {\n    march_part(p);\n}\n"),
                     2);
}

double size_of(int terms) {
    std::string formula = "z";
    for (int k = 1; k <= terms; ++k)
        formula += fmt::format("*(1 + 0.01*sin({0}*x)*cos({0}.5*y))", k);
    use_shaders_of_source_tree();
    const Passes passes =
        assemble(scene_of("[surface]\nbounds = { sphere = 2 }\nformula = \"" + formula + "\"\n"));
    return passes.tapes ? passes.size_compiled : inlined_size(passes);
}

TEST(InlinedSize, GrowsAsAFormulaDoes) {
    // Long formulas take their gradient in the march: of one kind with one another.
    const double first = size_of(150), second = size_of(300), third = size_of(450);
    EXPECT_GT(first, 150 * 4);
    EXPECT_NEAR((third - second) / (second - first), 1, 0.02);
}

TEST(InlinedSize, WhatADriverCompilesTooLongIsRefused) {
    Passes passes;
    passes.list.emplace_back();
    std::string text = "void main() {\n";
    for (int k = 0; k < 200; ++k) text += "    x = x + 1.0;\n";
    passes.list[0].text = text + "}\n";
    EXPECT_NO_THROW(check_size(passes));
    ::setenv("ISOMOTION_LARGEST_SHADERS", "399", 1);
    EXPECT_THROW(check_size(passes), std::length_error);
    // What few frames need is compiled for those.
    passes.list[0].when = When::where_fused_ends;
    EXPECT_NO_THROW(check_size(passes));
    for (const char* wrong : {"", "many", "-1", "1e3x", "nan"}) {
        ::setenv("ISOMOTION_LARGEST_SHADERS", wrong, 1);
        EXPECT_THROW(check_size(passes), std::invalid_argument) << wrong;
    }
    ::unsetenv("ISOMOTION_LARGEST_SHADERS");
}

} // namespace
} // namespace isomotion::shader
