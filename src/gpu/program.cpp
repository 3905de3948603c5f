#include "gpu/program.h"

#include "gpu/compute.h"
#include "gpu/context.h"

#include <glad/gl.h>

namespace isomotion::gpu {
namespace {

std::string stage_name(GLenum stage) {
    if (stage == GL_COMPUTE_SHADER) return "compute";
    return stage == GL_VERTEX_SHADER ? "vertex" : "fragment";
}

/// Lives until the program is linked.
class Shader {
public:
    Shader(GLenum stage, std::string_view source, std::string_view label)
        : number_(glCreateShader(stage)) {
        const char* text = source.data();
        const auto length = GLint(source.size());
        glShaderSource(number_, 1, &text, &length);
        glCompileShader(number_);
        GLint done = GL_FALSE;
        glGetShaderiv(number_, GL_COMPILE_STATUS, &done);
        if (done) return;
        const std::string told = log();
        glDeleteShader(number_);
        throw CompileError(label, stage_name(stage), told, source);
    }
    ~Shader() { glDeleteShader(number_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    GLuint number() const { return number_; }

private:
    std::string log() const {
        GLint size = 0;
        glGetShaderiv(number_, GL_INFO_LOG_LENGTH, &size);
        std::string text(std::size_t(size), '\0');
        glGetShaderInfoLog(number_, size, &size, text.data());
        text.resize(std::size_t(size));
        return text;
    }

    GLuint number_;
};

std::string link_log(GLuint program) {
    GLint size = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
    std::string text(std::size_t(size), '\0');
    glGetProgramInfoLog(program, size, &size, text.data());
    text.resize(std::size_t(size));
    return text;
}

} // namespace

Program::Program(std::string_view vertex, std::string_view fragment, std::string_view label) {
    const Shader first(GL_VERTEX_SHADER, vertex, label);
    const Shader second(GL_FRAGMENT_SHADER, fragment, label);
    link({first.number(), second.number()}, label);
}

Program Program::compute(std::string_view source, std::string_view label) {
    expect_compute(Context::current()->info(), label);
    const Shader shader(GL_COMPUTE_SHADER, source, label);
    Program program;
    program.link({shader.number()}, label);
    return program;
}

void Program::link(std::initializer_list<unsigned> shaders, std::string_view label) const {
    const GLuint program = name_.get();
    for (const GLuint shader : shaders) glAttachShader(program, shader);
    glLinkProgram(program);
    for (const GLuint shader : shaders) glDetachShader(program, shader);
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) throw CompileError(label, "link", link_log(program), {});
}

void Program::use() const { glUseProgram(name_.get()); }

int Program::uniform_location(std::string_view uniform) const {
    if (const auto known = locations_.find(uniform); known != locations_.end())
        return known->second;
    std::string key(uniform);
    const int location = glGetUniformLocation(name_.get(), key.c_str());
    locations_.emplace(std::move(key), location);
    return location;
}

void Program::set(std::string_view uniform, int value) const {
    use();
    glUniform1i(uniform_location(uniform), value);
}

void Program::set(std::string_view uniform, unsigned value) const {
    use();
    glUniform1ui(uniform_location(uniform), value);
}

void Program::set(std::string_view uniform, float value) const {
    use();
    glUniform1f(uniform_location(uniform), value);
}

void Program::set(std::string_view uniform, glm::vec2 value) const {
    use();
    glUniform2f(uniform_location(uniform), value.x, value.y);
}

void Program::set(std::string_view uniform, glm::vec3 value) const {
    use();
    glUniform3f(uniform_location(uniform), value.x, value.y, value.z);
}

void Program::set(std::string_view uniform, glm::vec4 value) const {
    use();
    glUniform4f(uniform_location(uniform), value.x, value.y, value.z, value.w);
}

void Program::set(std::string_view uniform, glm::ivec2 value) const {
    use();
    glUniform2i(uniform_location(uniform), value.x, value.y);
}

void Program::set(std::string_view uniform, glm::ivec3 value) const {
    use();
    glUniform3i(uniform_location(uniform), value.x, value.y, value.z);
}

void Program::set(std::string_view uniform, glm::ivec4 value) const {
    use();
    glUniform4i(uniform_location(uniform), value.x, value.y, value.z, value.w);
}

void Program::set(std::string_view uniform, std::span<const float> values) const {
    use();
    glUniform1fv(uniform_location(uniform), GLsizei(values.size()), values.data());
}

void Program::set(std::string_view uniform, std::span<const glm::vec4> values) const {
    use();
    glUniform4fv(uniform_location(uniform), GLsizei(values.size()), &values.data()->x);
}

void Program::bind_block(std::string_view block, unsigned binding) const {
    const std::string key(block);
    const GLuint index = glGetUniformBlockIndex(name_.get(), key.c_str());
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(name_.get(), index, binding);
}

} // namespace isomotion::gpu
