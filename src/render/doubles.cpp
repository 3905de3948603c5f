#include "render/doubles.h"

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "formula/glsl/glsl.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"

namespace isomotion::render {
namespace {

constexpr int side = 64;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Literals as constants of a formula are written.
constexpr std::array literals{0.1,
                              1.0 / 3,
                              0x1.fffffffffffffp-1,
                              0x1.0000000000001p0,
                              1e-300,
                              1e300,
                              123456789.123456789,
                              9007199254740993.0,
                              2.5e-8,
                              1e22,
                              1e23,
                              0x1.921fb54442d18p1};

struct Pair {
    double a, b;
};

enum class Precision { exact, as_float, nearly };

struct Operation {
    const char* text;
    double (*of)(double a, double b);
    Precision precision = Precision::exact;
};

// As shaders/probe/doubles.glsl numbers them. Minimum and maximum of NaN are not asked for.
constexpr std::array<Operation, 14> operations{{
    {"a + b", [](double a, double b) { return a + b; }},
    {"a - b", [](double a, double b) { return a - b; }},
    {"a*b", [](double a, double b) { return a * b; }},
    {"(a + b) - a", [](double a, double b) { return (a + b) - a; }},
    {"min(a, b)", [](double a, double b) { return std::fmin(a, b); }},
    {"max(a, b)", [](double a, double b) { return std::fmax(a, b); }},
    {"a < b", [](double a, double b) { return a < b ? 1.0 : 0.0; }},
    {"a >= b", [](double a, double b) { return a >= b ? 1.0 : 0.0; }},
    {"floor(a)", [](double a, double) { return std::floor(a); }},
    {"abs(a)", [](double a, double) { return std::abs(a); }},
    {"float(a)", [](double a, double) { return a; }, Precision::as_float},
    {"a literal", nullptr},
    {"a/b", [](double a, double b) { return a / b; }, Precision::nearly},
    {"sqrt(a)", [](double a, double) { return std::sqrt(a); }, Precision::nearly},
}};
constexpr std::size_t literal_operation = 11;

// Each with each, then random ones: of all sizes, that cancel, that end halfway between doubles.
std::vector<Pair> operands() {
    const std::vector<double> nasty{0,
                                    1,
                                    0x1.0000000000001p0,
                                    0x1.fffffffffffffp-1,
                                    0x1p-53,
                                    0x1.0000000000001p-53,
                                    0x1p-54,
                                    0x1.8p-1,
                                    3,
                                    1.0 / 3,
                                    0.1,
                                    0x1p53,
                                    0x1p27,
                                    0x1p-27,
                                    0x1.0000002p0,
                                    0x1.000001p27,
                                    1e-30,
                                    1e30,
                                    FLT_MAX,
                                    FLT_MIN,
                                    0x1.fffffffffffffp52,
                                    DBL_MAX,
                                    DBL_MIN,
                                    0x1p-1020,
                                    0x1p1021,
                                    0x1p-511,
                                    infinity,
                                    nan};
    std::vector<Pair> pairs;
    for (const double a : nasty) {
        for (const double b : nasty) {
            for (const double sign : {1.0, -1.0}) pairs.push_back({a, sign * b});
        }
    }
    for (const double a : nasty) pairs.push_back({-a, -a});
    std::mt19937_64 engine(1);
    const auto below = [&](std::uint64_t bound) { return engine() % bound; };
    const auto mantissa = [&] { return 1 + double(engine() >> 12) * 0x1p-52; };
    while (pairs.size() < std::size_t(side) * side) {
        const double sign = below(2) == 0 ? 1 : -1;
        const double a = std::ldexp(mantissa(), int(below(1000)) - 500);
        switch (below(4)) {
        case 0:
            pairs.push_back({a, sign * std::ldexp(mantissa(), int(below(1000)) - 500)});
            break;
        case 1:
            pairs.push_back({a, sign * a * (1 + std::ldexp(mantissa(), -int(below(60))))});
            break;
        case 2: // half of a's last bit, or odd multiples of it
            pairs.push_back({a, sign * std::ldexp(1.0 + double(2 * below(8)), std::ilogb(a) - 53)});
            break;
        default: { // products of 54 bits
            const auto odd = [&] {
                return double((std::uint64_t{1} << 26) + 2 * below(1u << 25) + 1);
            };
            pairs.push_back({odd(), sign * odd()});
        }
        }
    }
    return pairs;
}

gpu::Texture texture_of(const std::vector<Pair>& pairs, double Pair::*operand) {
    std::vector<float> texels;
    texels.reserve(4 * pairs.size());
    for (const Pair& pair : pairs) {
        const auto bits = std::bit_cast<std::uint64_t>(pair.*operand);
        for (int k = 0; k < 4; ++k) texels.push_back(float(bits >> (16 * k) & 0xffff));
    }
    return {gpu::Format::rgba32f, side, side, texels};
}

double double_of(std::span<const float, 4> parts) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) bits |= std::uint64_t(parts[k]) << (16 * k);
    return std::bit_cast<double>(bits);
}

// No array holds the literals: NVIDIA's compiler rounds doubles of arrays to floats where the index
// is none of its constants. Shaders of proofs have no such arrays.
std::string probe() {
    std::string cases;
    for (std::size_t k = 0; k < literals.size(); ++k) {
        cases += fmt::format("    if (k == {}) return {};\n", k,
                             formula::glsl_double_literal(literals[k]));
    }
    shader::ShaderText text;
    text.version(400);
    text.define(shader::Feature::literals, int(literals.size()));
    text.generated("constants as formulas have them",
                   fmt::format("double literal(int k) {{\n{}    return 0.0lf;\n}}\n", cases));
    text.file("probe/doubles.glsl");
    return text.text();
}

// Whether `found` is what shaders count on. What is below the smallest normal double may be 0.
bool is_as_expected(double found, double expected, Precision precision, const Pair& of) {
    if (std::isnan(expected)) return precision == Precision::nearly || std::isnan(found);
    const double size = std::abs(expected);
    if (size <= DBL_MIN) return std::abs(found) <= DBL_MIN;
    switch (precision) {
    case Precision::exact:
        return found == expected;
    case Precision::as_float:
        if (size < FLT_MIN) return std::abs(found) <= FLT_MIN;
        return size > FLT_MAX || std::abs(found - expected) <= size * 0x1p-23;
    case Precision::nearly:
        // Half of what is counted. Large divisors may make 0.
        if (std::isinf(expected)) return found == expected;
        return std::abs(found - expected) <= size * 0x1p-51 ||
               (found == 0 && std::abs(of.b) > 0x1p1021);
    }
    return false;
}

bool is_asked_for(std::size_t operation, const Pair& of) {
    const std::string_view text = operations[operation].text;
    const bool has_nan = std::isnan(of.a) || std::isnan(of.b);
    if (text == "min(a, b)" || text == "max(a, b)") return !has_nan;
    return text != "sqrt(a)" || !(of.a < 0);
}

} // namespace

std::string fault_of_doubles(int first_unit) {
    const gpu::Program program("#version 330 core\n" + shader::read_shader("probe/corners.vert"),
                               probe(), "doubles");
    const std::vector<Pair> pairs = operands();
    const gpu::Texture first = texture_of(pairs, &Pair::a), second = texture_of(pairs, &Pair::b);
    const gpu::Target target(side, side);
    program.bind_sampler("first", first_unit);
    program.bind_sampler("second", first_unit + 1);
    for (std::size_t k = 0; k < operations.size(); ++k) {
        target.bind();
        first.bind(first_unit);
        second.bind(first_unit + 1);
        program.set("operation", int(k));
        gpu::Fullscreen().draw();
        const std::vector<float> results = target.read(0, 0, 0, side, side);
        for (std::size_t i = 0; i < std::size_t(side) * side; ++i) {
            const Pair& of = pairs[i];
            if (!is_asked_for(k, of)) continue;
            const double found = double_of(std::span(results).subspan(4 * i).first<4>());
            const double expected = k == literal_operation ? literals[i % side % literals.size()]
                                                           : operations[k].of(of.a, of.b);
            if (is_as_expected(found, expected, operations[k].precision, of)) continue;
            return fmt::format("{} at {:a} and {:a}: {:a}, not {:a}", operations[k].text, of.a,
                               of.b, found, expected);
        }
    }
    return {};
}

bool can_trust_doubles(int first_unit) {
    const gpu::Context* context = gpu::Context::current();
    return context && context->info().has(4, 0) && fault_of_doubles(first_unit).empty();
}

} // namespace isomotion::render
