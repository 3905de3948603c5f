#pragma once

#include "unit/gpu/every_backend.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace isomotion::kernels {

inline constexpr float saturation = 1.0e30f;

/// Arguments of one call; one-place kernels ignore the second.
struct Arguments {
    float a = 0, b = 0;
};

/// What stands before the kernels: a version, and how to say `precise` there.
struct Prelude {
    const char* name;
    const char* text;
};

inline constexpr Prelude desktop_450 = {"4.50 core", "#version 450 core\n"};
inline constexpr Prelude desktop_330 = {
    "3.30 core", "#version 330 core\n#extension GL_ARB_gpu_shader5 : require\n"};
inline constexpr Prelude plain_330 = {"3.30 core, no precise",
                                      "#version 330 core\n#define precise\n"};
inline constexpr Prelude web = {
    "3.00 es", "#version 300 es\nprecision highp float;\nprecision highp int;\n#define precise\n"};

inline std::string shader_text(const std::string& name) {
    const auto path = std::string(ISOMOTION_SOURCE_DIR "/shaders/") + name + ".glsl";
    std::ifstream stream(path);
    if (!stream) throw std::runtime_error("cannot read " + path);
    return (std::ostringstream() << stream.rdbuf()).str();
}

/// The text of all kernels, each after what it needs, and what the prelude defines for all
/// versions.
inline std::string kernel_source() {
    const std::string prelude = shader_text("prelude");
    std::string source = prelude.substr(prelude.find("#define IM_SATURATION"));
    for (const char* file : {"bits", "divide", "sqrt", "exp", "log", "pow", "trig", "inverse_trig",
                             "inverse_hyperbolic", "erf", "cbrt"}) {
        source += shader_text(std::string("math/") + file);
    }
    return source;
}

/// Calls a kernel on the GPU for many arguments at once.
class KernelProgram {
public:
    /// `call` is a GLSL expression of the floats a and b.
    KernelProgram(const Prelude& prelude, const std::string& call)
        : program_(vertex(prelude), fragment(prelude, call), call) {}

    std::vector<float> operator()(std::span<const Arguments> arguments) const {
        constexpr int width = 512;
        const int height = int((arguments.size() + width - 1) / width);
        std::vector<float> texels(std::size_t(width) * std::size_t(height) * 2);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            texels[2 * i] = arguments[i].a;
            texels[2 * i + 1] = arguments[i].b;
        }
        const gpu::Texture input(gpu::Format::rg32f, width, height, texels);
        const gpu::Target output(width, height);
        input.bind(0);
        program_.bind_sampler("arguments", 0);
        output.bind();
        gpu::Fullscreen().draw();
        const auto pixels = output.read(0, 0, 0, width, height);
        std::vector<float> results(arguments.size());
        for (std::size_t i = 0; i < results.size(); ++i) results[i] = pixels[4 * i];
        return results;
    }

private:
    static std::string vertex(const Prelude& prelude) {
        return prelude.text + std::string("void main() { gl_Position = vec4(vec2(gl_VertexID & 1, "
                                          "gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n");
    }

    static std::string fragment(const Prelude& prelude, const std::string& call) {
        return prelude.text + kernel_source() +
               "uniform highp sampler2D arguments;\n"
               "out vec4 result;\n"
               "void main() {\n"
               "    vec2 given = texelFetch(arguments, ivec2(gl_FragCoord.xy), 0).rg;\n"
               "    float a = given.r, b = given.g;\n"
               "    result = vec4(" +
               call + ");\n}\n";
    }

    gpu::Program program_;
};

/// The spacing of floats around a value.
inline double ulp(double value) {
    constexpr int smallest_exponent = -126;
    const int exponent =
        value == 0 ? smallest_exponent : std::max(std::ilogb(value), smallest_exponent);
    return std::ldexp(1.0, exponent - 23);
}

} // namespace isomotion::kernels
