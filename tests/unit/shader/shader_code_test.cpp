#include "shader/shader_code.h"

#include <gtest/gtest.h>

#include "scenes.h"
#include "shader/assemble.h"

namespace isomotion::shader {
namespace {

TEST(ShaderCode, HasNoCommentsAndNoBlanks) {
    EXPECT_EQ(code_of(""), "");
    EXPECT_EQ(code_of("\n\n  \n"), "");
    EXPECT_EQ(code_of("// a\nfloat x; // b\n\n    // c\n\tfloat y;  \nint a//"),
              "float x;\nfloat y;\nint a\n");
    EXPECT_EQ(code_of("x = a / b;"), "x = a / b;\n");
    EXPECT_EQ(code_of(code_of("  a // b\n\n c")), "a\nc\n");
}

// What is no code decides no picture.
TEST(ShaderCode, DecidesTheFingerprintAlone) {
    use_shaders_of_source_tree();
    Passes passes = assemble(scene_of(surface_text("x^2 + y^2 + z^2 - 1")));
    const std::string before = passes.fingerprint();
    std::string& text = passes.list.front().text;
    text += "\n// another comment\n\n";
    EXPECT_EQ(passes.fingerprint(), before);
    text += "int another;\n";
    EXPECT_NE(passes.fingerprint(), before);
}

// Code that a comment begins inside of would be lost.
TEST(ShaderCode, NoShaderHasOtherComments) {
    use_shaders_of_source_tree();
    for (const std::string& file : shader_files()) {
        const std::string text = read_shader(file);
        EXPECT_EQ(text.find("/*"), std::string::npos) << file;
        EXPECT_EQ(text.find('"'), std::string::npos) << file;
        EXPECT_EQ(text.find("\\\n"), std::string::npos) << file;
    }
}

} // namespace
} // namespace isomotion::shader
