#include "every_backend.h"

#include <array>

namespace isomotion::gpu {
namespace {

class ProgramTest : public EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(ProgramTest);

std::string compile_error(const std::string& vertex, const std::string& fragment,
                          std::string& stage) {
    try {
        Program(vertex, fragment, "broken");
    } catch (const CompileError& error) {
        stage = error.stage();
        EXPECT_FALSE(error.log().empty());
        return error.what();
    }
    ADD_FAILURE() << "it compiled";
    return {};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST_P(ProgramTest, ACompileErrorShowsTheLine) {
    std::string stage;
    const auto message = compile_error(fullscreen_vertex,
                                       "#version 330 core\n"
                                       "out vec4 color;\n"
                                       "\n"
                                       "void main() {\n"
                                       "    float a = undeclared_name;\n"
                                       "    color = vec4(a);\n"
                                       "}\n",
                                       stage);
    EXPECT_EQ(stage, "fragment");
    EXPECT_TRUE(contains(message, "broken: the fragment shader failed")) << message;
    EXPECT_TRUE(contains(message, "undeclared_name")) << message;
    EXPECT_TRUE(contains(message, ">     5 |     float a = undeclared_name;")) << message;
    EXPECT_TRUE(contains(message, "      4 | void main() {")) << message;
    EXPECT_FALSE(contains(message, "#version")) << message;
}

TEST_P(ProgramTest, ACompileErrorFollowsLineDirectives) {
    std::string stage;
    const auto message = compile_error("#version 330 core\n"
                                       "void fine() {}\n"
                                       "#line 100 7\n"
                                       "void main() { gl_Position = 3; }\n",
                                       "#version 330 core\nvoid main() {}\n", stage);
    EXPECT_EQ(stage, "vertex");
    EXPECT_TRUE(contains(message, ">   100 | void main()")) << message;
}

TEST_P(ProgramTest, ALinkErrorNamesTheStep) {
    std::string stage;
    const auto message = compile_error("#version 330 core\n"
                                       "out vec3 passed;\n"
                                       "void main() { passed = vec3(1.0); }\n",
                                       "#version 330 core\n"
                                       "in vec4 passed; out vec4 color;\n"
                                       "void main() { color = passed; }\n",
                                       stage);
    EXPECT_EQ(stage, "link");
    EXPECT_TRUE(contains(message, "passed")) << message;
}

TEST_P(ProgramTest, UniformsOfEveryTypeArrive) {
    const Program program = fullscreen_program(
        "uniform int i; uniform uint u; uniform float f; uniform vec2 v2; uniform vec3 v3;"
        "uniform vec4 v4; uniform ivec2 i2; uniform ivec3 i3; uniform ivec4 i4;"
        "uniform float list[3]; out vec4 color;",
        "color = vec4(float(i) + float(u) + f + v2.y + v3.z + v4.w + float(i2.y + i3.z + i4.w)"
        " + list[2]);");
    program.set("i", -1);
    program.set("u", 20u);
    program.set("f", 300.0f);
    program.set("v2", glm::vec2(9, 4000));
    program.set("v3", glm::vec3(9, 9, 50000));
    program.set("v4", glm::vec4(9, 9, 9, 0.5f));
    program.set("i2", glm::ivec2(9, 100000));
    program.set("i3", glm::ivec3(9, 9, 200000));
    program.set("i4", glm::ivec4(9, 9, 9, 400000));
    program.set("list", std::array{9.0f, 9.0f, 0.25f});
    EXPECT_EQ(draw_one(program), 754319.75f);
}

TEST_P(ProgramTest, WhatTheDriverDroppedIsHarmless) {
    const Program program =
        fullscreen_program("uniform float unused; out vec4 color;", "color = vec4(1.0);");
    EXPECT_EQ(program.uniform_location("unused"), -1);
    EXPECT_EQ(program.uniform_location("unused"), -1);
    program.set("unused", 3.0f);
    program.set("never_there", glm::vec3(1));
    program.bind_block("NoBlock", 0);
    program.bind_sampler("no_sampler", 0);
    EXPECT_NO_THROW(expect_success("setting what is not there"));
    EXPECT_EQ(draw_one(program), 1.0f);
}

TEST_P(ProgramTest, MovesWithoutLosingItself) {
    Program first = fullscreen_program("out vec4 color;", "color = vec4(1.0);");
    Program second = fullscreen_program("out vec4 color;", "color = vec4(2.0);");
    Program moved = std::move(first);
    EXPECT_EQ(draw_one(moved), 1.0f);
    second = std::move(moved);
    EXPECT_EQ(draw_one(second), 1.0f);
}

} // namespace
} // namespace isomotion::gpu
