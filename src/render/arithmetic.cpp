#include "render/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <string>

#include <fmt/format.h>

#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "render/doubles.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"

namespace isomotion::render {
namespace {

struct Question {
    const char* what;
    const char *yes, *no;
    const char* glsl; // a bool
    bool ieee;
};

// Values come from uniforms: a compiler answers for itself, not for the machine. `a` is 1 + 2^-12,
// whose square is c = 1 + 2^-11 and a bit that only a fused sum keeps; `large` + 1 is `large`.
constexpr Question questions[] = {
    {"denormal arguments", "kept", "read as 0", "tiny * 1.2676506e30 > 0.0", true},
    {"denormal results", "kept", "flushed to 0",
     "(floatBitsToUint(smallest * 0.25) & 0x7fffffffu) != 0u", true},
    {"isnan(0/0)", "true", "false", "isnan(zero / zero)", true},
    {"NaN != NaN", "true", "false", "nan != nan", true},
    {"NaN < 1", "true", "false", "nan < one", false},
    {"NaN >= 1", "true", "false", "nan >= one", false},
    {"!(NaN < 1)", "true", "false", "!(nan < one)", true},
    {"min(NaN, 1)", "1", "NaN", "min(nan, one) == one", true},
    {"min(1, NaN)", "1", "NaN", "min(one, nan) == one", true},
    {"max(NaN, 1)", "1", "NaN", "max(nan, one) == one", true},
    {"max(1, NaN)", "1", "NaN", "max(one, nan) == one", true},
    {"1/0", "infinity", "something else", "floatBitsToUint(one / zero) == 0x7f800000u", true},
    {"infinity - infinity", "NaN", "a number",
     "(floatBitsToUint(one / zero - a / zero) & 0x7fffffffu) > 0x7f800000u", true},
    {"fma(a, b, c)", "fused", "rounded twice", "fused(a, a, -c) != 0.0", true},
    {"a*b + c", "contracted to a fused one", "as written", "a * a - c != 0.0", false},
    {"precise a*b + c", "contracted to a fused one", "as written", "precise_product() != 0.0",
     false},
    {"(a + b) - a", "reassociated to b", "as written", "(large + one) - large != 0.0", false},
    {"precise (a + b) - a", "reassociated to b", "as written", "precise_sum() != 0.0", false},
};

// A vertex shader for a picture of one draw.
std::string corners() { return "#version 330 core\n" + shader::read_shader("probe/corners.vert"); }

std::string question_shader() {
    std::string main =
        "void main() {\n"
        "    float nan = uintBitsToFloat(nan_bits), tiny = uintBitsToFloat(tiny_bits);\n"
        "    bool answer = false;\n"
        "    switch (int(gl_FragCoord.x)) {\n";
    for (std::size_t k = 0; k < std::size(questions); ++k) {
        main += fmt::format("    case {}: answer = {}; break;\n", k, questions[k].glsl);
    }
    main += "    }\n    answers = vec4(answer);\n}\n";
    shader::ShaderText text;
    text.file("probe/arithmetic.glsl");
    text.generated("questions", main);
    return text.text();
}

enum class Unit { value, one };

struct Sweep {
    const char* function;
    const char* kernel;                 // of shaders/math/
    const char *driver_call, *own_call; // of the floats a and b
    double (*exact)(double a, double b);
    double low, high; // of a
    bool by_size;     // over the exponents of a
    double b_low, b_high;
    Unit unit;
};

constexpr double none = 0;
constexpr Sweep sweeps[] = {
    {"exp", "exp", "exp(a)", "im_exp(a)", [](double a, double) { return std::exp(a); }, -80, 60,
     false, none, none, Unit::value},
    {"log", "log", "log(a)", "im_log(a)", [](double a, double) { return std::log(a); }, 1e-30, 1e30,
     true, none, none, Unit::value},
    {"pow", "pow", "pow(a, b)", "im_pow(a, b)", [](double a, double b) { return std::pow(a, b); },
     0.01, 10, false, -8, 8, Unit::value},
    {"sin", "sin", "sin(a)", "im_sin(a)", [](double a, double) { return std::sin(a); }, -10, 10,
     false, none, none, Unit::one},
    {"sin, far", "sin", "sin(a)", "im_sin(a)", [](double a, double) { return std::sin(a); }, -1e5,
     1e5, false, none, none, Unit::one},
    {"cos", "cos", "cos(a)", "im_cos(a)", [](double a, double) { return std::cos(a); }, -10, 10,
     false, none, none, Unit::one},
    {"asin", "asin", "asin(a)", "im_asin(a)", [](double a, double) { return std::asin(a); }, -1, 1,
     false, none, none, Unit::one},
    {"acos", "acos", "acos(a)", "im_acos(a)", [](double a, double) { return std::acos(a); }, -1, 1,
     false, none, none, Unit::one},
    {"atan", "atan", "atan(a)", "im_atan(a)", [](double a, double) { return std::atan(a); }, -8, 8,
     false, none, none, Unit::one},
    {"sqrt", "sqrt", "sqrt(a)", "im_sqrt(a)", [](double a, double) { return std::sqrt(a); }, 1e-30,
     1e30, true, none, none, Unit::value},
    {"a/b", "divide", "a / b", "im_divide(a, b)", [](double a, double b) { return a / b; }, 1e-20,
     1e20, true, 0.5, 8, Unit::value},
};

constexpr int columns = 512, rows = 64;

struct Arguments {
    float a, b;
};

// The second argument goes round often while the first goes once, by a step that never repeats.
std::vector<Arguments> arguments_of(const Sweep& sweep) {
    constexpr double golden = 0.6180339887498949;
    std::vector<Arguments> all(std::size_t(columns) * rows);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double part = double(i) / double(all.size() - 1);
        const double turn = golden * double(i);
        const double a = sweep.by_size ? sweep.low * std::pow(sweep.high / sweep.low, part)
                                       : sweep.low + (sweep.high - sweep.low) * part;
        all[i] = {float(a),
                  float(sweep.b_low + (sweep.b_high - sweep.b_low) * (turn - std::floor(turn)))};
    }
    return all;
}

std::string sweep_shader(const Sweep& sweep) {
    shader::ShaderText text;
    for (const std::string& file : shader::kernel_files({sweep.kernel})) text.file(file);
    text.generated("sweep", fmt::format("uniform sampler2D arguments;\n"
                                        "out vec4 results;\n"
                                        "void main() {{\n"
                                        "    vec2 given = texelFetch(arguments, "
                                        "ivec2(gl_FragCoord.xy), 0).rg;\n"
                                        "    float a = given.r, b = given.g;\n"
                                        "    results = vec4({}, {}, 0.0, 0.0);\n"
                                        "}}\n",
                                        sweep.driver_call, sweep.own_call));
    return text.text();
}

// The results, four numbers for each of the arguments.
std::vector<float> run(const Sweep& sweep, std::span<const Arguments> arguments) {
    const gpu::Program program(corners(), sweep_shader(sweep), sweep.function);
    std::vector<float> texels;
    texels.reserve(2 * arguments.size());
    for (const auto& [a, b] : arguments) texels.insert(texels.end(), {a, b});
    const gpu::Texture input(gpu::Format::rg32f, columns, rows, texels);
    const gpu::Target target(columns, rows);
    target.bind();
    input.bind(0);
    program.bind_sampler("arguments", 0);
    program.use();
    gpu::Fullscreen().draw();
    return target.read(0, 0, 0, columns, rows);
}

// The distance from the float next to the value to the float after it.
double spacing(double value) {
    const double least = std::numeric_limits<float>::min();
    return std::ldexp(1.0, std::ilogb(std::max(std::abs(value), least)) - 23);
}

double error_of(float result, double exact, Unit unit) {
    if (std::isnan(result)) return std::numeric_limits<double>::infinity();
    return std::abs(double(result) - exact) / spacing(unit == Unit::one ? 1.0 : exact);
}

Behaviour of_doubles() {
    const gpu::Context* context = gpu::Context::current();
    if (!context || !context->info().has(4, 0)) return {"doubles", "none", true};
    const std::string fault = fault_of_doubles();
    return {"doubles", fault.empty() ? "as IEEE 754 has them" : fault, fault.empty()};
}

} // namespace

std::vector<Behaviour> behaviours() {
    const gpu::Program program(corners(), question_shader(), "behaviours");
    const auto count = int(std::size(questions));
    const gpu::Target target(count, 1);
    target.bind();
    program.set("zero", 0.0f);
    program.set("one", 1.0f);
    program.set("a", 1 + 0x1p-12f);
    program.set("c", 1 + 0x1p-11f);
    program.set("large", 1e9f);
    program.set("smallest", std::numeric_limits<float>::min());
    program.set("nan_bits", 0x7fc00000u);
    program.set("tiny_bits", 1u << 9); // 2^-140
    program.use();
    gpu::Fullscreen().draw();
    const std::vector<float> answers = target.read(0, 0, 0, count, 1);

    std::vector<Behaviour> found;
    for (std::size_t k = 0; k < std::size(questions); ++k) {
        const Question& question = questions[k];
        const bool answer = answers[4 * k] != 0;
        found.push_back(
            {question.what, answer ? question.yes : question.no, answer == question.ieee});
    }
    found.push_back(of_doubles());
    return found;
}

std::vector<FunctionError> function_errors() {
    std::vector<FunctionError> errors;
    for (const Sweep& sweep : sweeps) {
        FunctionError worst{sweep.function, sweep.low, sweep.high};
        const std::vector<Arguments> arguments = arguments_of(sweep);
        const std::vector<float> results = run(sweep, arguments);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const double exact = sweep.exact(arguments[i].a, arguments[i].b);
            const double of_driver = error_of(results[4 * i], exact, sweep.unit);
            if (of_driver > worst.of_driver) {
                worst.of_driver = of_driver;
                worst.driver_at = arguments[i].a;
            }
            worst.of_kernel =
                std::max(worst.of_kernel, error_of(results[4 * i + 1], exact, sweep.unit));
        }
        errors.push_back(worst);
    }
    return errors;
}

} // namespace isomotion::render
