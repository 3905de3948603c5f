// What the kernels of shaders/math are defined to give where a formula is at an edge.

#include "kernel.h"

#include <limits>

namespace isomotion::kernels::special_values_test {
namespace {

using gpu::EveryBackend;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::min();
constexpr float pi = 3.14159274f;

struct Case {
    const char* call;
    Arguments arguments;
    float expected; ///< exactly, except for `ulps`
    double ulps = 0;
};

const Case cases[] = {
    {"im_exp(a)", {0}, 1},
    {"im_exp(a)", {-0.0f}, 1},
    {"im_exp(a)", {1}, 2.71828183f, 1},
    {"im_exp(a)", {100}, saturation},
    {"im_exp(a)", {largest}, saturation},
    {"im_exp(a)", {infinity}, saturation},
    {"im_exp(a)", {-100}, 0},
    {"im_exp(a)", {-largest}, 0},
    {"im_exp(a)", {-infinity}, 0},
    {"im_exp(a)", {nan}, nan},
    {"im_exp(a) * b", {100, 0}, 0},
    {"im_exp(-a)", {nan}, nan},
    {"im_exp(b * a + 1.0)", {nan, 2}, nan},
    {"b - 3.0 * im_exp(-b * (a * a + b * b))", {nan, 2}, nan},

    {"im_sinh(a)", {0}, 0},
    {"im_sinh(a)", {1e-20f}, 1e-20f},
    {"im_sinh(a)", {100}, saturation},
    {"im_sinh(a)", {-100}, -saturation},
    {"im_sinh(a)", {infinity}, saturation},
    {"im_sinh(a)", {-infinity}, -saturation},
    {"im_sinh(a)", {nan}, nan},
    {"im_cosh(a)", {0}, 1},
    {"im_cosh(a)", {-100}, saturation},
    {"im_cosh(a)", {-infinity}, saturation},
    {"im_cosh(a)", {nan}, nan},
    {"im_tanh(a)", {1e-20f}, 1e-20f},
    {"im_tanh(a)", {50}, 1},
    {"im_tanh(a)", {-infinity}, -1},
    {"im_tanh(a)", {nan}, nan},

    {"im_asinh(a)", {0}, 0},
    {"im_asinh(a)", {1e-20f}, 1e-20f},
    {"im_asinh(a)", {1e-4f}, 9.99999983e-5f, 1},
    {"im_asinh(a)", {largest}, 89.4159862f, 1},
    {"im_asinh(a)", {-largest}, -89.4159862f, 1},
    {"im_asinh(a)", {nan}, nan},
    {"im_acosh(a)", {1}, 0},
    {"im_acosh(a)", {0.5f}, 0},
    {"im_acosh(a)", {-infinity}, 0},
    {"im_acosh(a)", {1.00000012f}, 4.88281246e-4f, 1},
    {"im_acosh(a)", {largest}, 89.4159862f, 1},
    {"im_acosh(a)", {nan}, nan},
    {"im_erf(a)", {0}, 0},
    {"im_erf(a)", {1e-20f}, 1.12837913e-20f, 2},
    {"im_erf(a)", {1e-4f}, 1.12837916e-4f, 2},
    {"im_erf(a)", {5}, 1},
    {"im_erf(a)", {infinity}, 1},
    {"im_erf(a)", {-infinity}, -1},
    {"im_erf(a)", {nan}, nan},
    {"im_cbrt(a)", {0}, 0},
    {"im_cbrt(a)", {1}, 1},
    {"im_cbrt(a)", {-27}, -3, 1},
    {"im_cbrt(a)", {1e-6f}, 0.01f, 1},
    {"im_cbrt(a)", {smallest}, 2.27373675e-13f, 1},
    {"im_cbrt(a)", {largest}, 6.98146361e12f, 1},
    {"im_cbrt(a)", {infinity}, infinity},
    {"im_cbrt(a)", {-infinity}, -infinity},
    {"im_cbrt(a)", {nan}, nan},
    {"1.0 - im_asinh(-a) + im_cbrt(-a)", {nan}, nan},
    {"im_acosh(2.0 * a) - im_erf(-a)", {nan}, nan},

    {"im_log(a)", {1}, 0},
    {"im_log(a)", {0}, -saturation},
    {"im_log(a)", {-0.0f}, -saturation},
    {"im_log(a)", {-1}, nan},
    {"im_log(a)", {-infinity}, nan},
    {"im_log(a)", {infinity}, saturation},
    {"im_log(a)", {smallest}, -87.3365448f, 1},
    {"im_log(a)", {largest}, 88.7228391f, 1},
    {"im_log(a)", {nan}, nan},
    {"1.0 - im_log(-a)", {nan}, nan},

    {"im_sqrt(a)", {0}, 0},
    {"im_sqrt(a)", {-1e-7f}, 0},
    {"im_sqrt(a)", {-infinity}, 0},
    {"im_sqrt(a)", {4}, 2},
    {"im_sqrt(a)", {nan}, nan},

    {"im_divide(a, b)", {1, 0}, saturation},
    {"im_divide(a, b)", {1, -0.0f}, saturation},
    {"im_divide(a, b)", {-1, 0}, -saturation},
    {"im_divide(a, b)", {-1, -0.0f}, -saturation},
    {"im_divide(a, b)", {0, 0}, nan},
    {"im_divide(a, b)", {1e20f, 1e-20f}, saturation},
    {"im_divide(a, b)", {1e20f, -1e-20f}, -saturation},
    {"im_divide(a, b)", {infinity, 2}, saturation},
    {"im_divide(a, b)", {1, infinity}, 0},
    {"im_divide(a, b)", {infinity, infinity}, nan},
    {"im_divide(a, b)", {nan, 1}, nan},
    {"im_divide(a, b)", {1, nan}, nan},
    {"im_divide(a, b)", {nan, 0}, nan},

    {"im_pow(a, b)", {0, 0}, 1},
    {"im_pow(a, b)", {5, 0}, 1},
    {"im_pow(a, b)", {-5, -0.0f}, 1},
    {"im_pow(a, b)", {nan, 0}, 1},
    {"im_pow(a, b)", {0, 2}, 0},
    {"im_pow(a, b)", {0, 0.5f}, 0},
    {"im_pow(a, b)", {0, -1}, saturation},
    {"im_pow(a, b)", {1, 1e30f}, 1},
    {"im_pow(a, b)", {1, -infinity}, 1},
    {"im_pow(a, b)", {2, 10}, 1024},
    {"im_pow(a, b)", {10, 3}, 1000},
    {"im_pow(a, b)", {-2, 3}, -8},
    {"im_pow(a, b)", {-2, 2}, 4},
    {"im_pow(a, b)", {-2, -1}, -0.5f},
    {"im_pow(a, b)", {-2, 0.5f}, nan},
    {"im_pow(a, b)", {-1, 16777216}, 1},
    {"im_pow(a, b)", {-10, 31}, -saturation},
    {"im_pow(a, b)", {10, 100}, saturation},
    {"im_pow(a, b)", {10, -100}, 0},
    {"im_pow(a, b)", {1.2f, largest}, saturation},
    {"im_pow(a, b)", {1.2f, infinity}, saturation},
    {"im_pow(a, b)", {0.8f, infinity}, 0},
    {"im_pow(a, b)", {0.8f, -infinity}, saturation},
    {"im_pow(a, b)", {infinity, 0.1f}, saturation},
    {"im_pow(a, b)", {infinity, -0.1f}, 0},
    {"im_pow(a, b)", {nan, 1}, nan},
    {"im_pow(a, b)", {1, nan}, nan},
    {"im_pow(a, b)", {-2, nan}, nan},

    {"im_sin(a)", {0}, 0},
    {"im_sin(a)", {1e-20f}, 1e-20f},
    {"im_sin(a)", {pi}, -8.74227766e-8f, 1},
    {"im_sin(a)", {infinity}, nan},
    {"im_sin(a)", {-infinity}, nan},
    {"im_sin(a)", {nan}, nan},
    {"im_cos(a)", {0}, 1},
    {"im_cos(a)", {pi / 2}, -4.37113883e-8f, 1},
    {"im_cos(a)", {infinity}, nan},
    {"im_cos(a)", {nan}, nan},
    {"im_tan(a)", {0}, 0},
    {"im_tan(a)", {pi / 2}, -22877332.4f, 2},
    {"im_tan(a)", {infinity}, nan},
    {"im_tan(a)", {nan}, nan},

    {"im_asin(a)", {0}, 0},
    {"im_asin(a)", {1}, pi / 2},
    {"im_asin(a)", {-1.0000001f}, -pi / 2},
    {"im_asin(a)", {nan}, nan},
    {"im_acos(a)", {1}, 0},
    {"im_acos(a)", {1.0000001f}, 0},
    {"im_acos(a)", {-1}, pi},
    {"im_acos(a)", {-infinity}, pi},
    {"im_acos(a)", {0}, pi / 2},
    {"im_acos(a)", {0.99999994f}, 3.45266977e-4f, 1},
    {"im_acos(a)", {nan}, nan},
    {"im_atan(a)", {0}, 0},
    {"im_atan(a)", {1}, pi / 4},
    {"im_atan(a)", {-1}, -pi / 4},
    {"im_atan(a)", {infinity}, pi / 2},
    {"im_atan(a)", {-infinity}, -pi / 2},
    {"im_atan(a)", {nan}, nan},
    {"im_atan2(a, b)", {0, 0}, 0},
    {"im_atan2(a, b)", {0, 1}, 0},
    {"im_atan2(a, b)", {0, -1}, pi},
    {"im_atan2(a, b)", {-0.0f, -1}, pi},
    {"im_atan2(a, b)", {1, 0}, pi / 2},
    {"im_atan2(a, b)", {-1, 0}, -pi / 2},
    {"im_atan2(a, b)", {1, 1}, pi / 4},
    {"im_atan2(a, b)", {-1, -1}, -3 * pi / 4, 1},
    {"im_atan2(a, b)", {infinity, 1}, pi / 2},
    {"im_atan2(a, b)", {-1, infinity}, 0, 1},
    {"im_atan2(a, b)", {infinity, -infinity}, 3 * pi / 4, 1},
    {"im_atan2(a, b)", {largest, largest}, pi / 4},
    {"im_atan2(a, b)", {nan, 1}, nan},
    {"im_atan2(a, b)", {1, nan}, nan},
    {"im_atan2(a, b)", {nan, 0}, nan},
    {"im_asin(1.0 - a) + im_acos(-a)", {nan}, nan},
    {"im_sinh(-a) - 1.0", {nan}, nan},
    {"im_cosh(2.0 * a)", {nan}, nan},
    {"1.0 - im_tanh(-a)", {nan}, nan},
    {"1.0 / im_divide(b, -a)", {nan, 1}, nan},

    {"im_is_nan(a) ? 1.0 : 0.0", {nan}, 1},
    {"im_is_nan(a) ? 1.0 : 0.0", {-nan}, 1},
    {"im_is_nan(a) ? 1.0 : 0.0", {infinity}, 0},
    {"im_is_nan(a) ? 1.0 : 0.0", {-infinity}, 0},
    {"im_is_nan(a) ? 1.0 : 0.0", {largest}, 0},
    {"im_is_nan(a) ? 1.0 : 0.0", {0}, 0},
};

bool agrees(float result, const Case& wanted) {
    if (std::isnan(wanted.expected)) return std::isnan(result);
    if (std::isinf(wanted.expected)) return result == wanted.expected;
    const double off = std::abs(double(result) - double(wanted.expected));
    return off <= wanted.ulps * ulp(wanted.expected);
}

class SpecialValuesTest : public EveryBackend {
protected:
    void expect_all(const Prelude& prelude) const {
        for (std::size_t first = 0, next = 0; first < std::size(cases); first = next) {
            const std::string call = cases[first].call;
            std::vector<Arguments> arguments;
            while (next < std::size(cases) && cases[next].call == call)
                arguments.push_back(cases[next++].arguments);
            const auto results = KernelProgram(prelude, call)(arguments);
            for (std::size_t i = 0; i < results.size(); ++i)
                EXPECT_TRUE(agrees(results[i], cases[first + i]))
                    << call << " at a = " << arguments[i].a << ", b = " << arguments[i].b
                    << " gives " << results[i] << ", not " << cases[first + i].expected << ", in "
                    << prelude.name;
        }
    }
};
ISOMOTION_ON_EVERY_BACKEND(SpecialValuesTest);

TEST_P(SpecialValuesTest, AreAsDefined) { expect_all(desktop_330); }

TEST_P(SpecialValuesTest, AreTheSameInTheNewestVersion) {
    if (context->info().major * 10 + context->info().minor < 45) GTEST_SKIP() << "no OpenGL 4.5";
    expect_all(desktop_450);
}

// Accuracy is for `precise` to keep; being defined is not.
TEST_P(SpecialValuesTest, CompileWithoutPrecise) {
    const KernelProgram kernel(plain_330, "im_exp(a) + im_pow(a, b) + im_sin(a)");
    const Arguments arguments[] = {{0, 1}};
    EXPECT_EQ(kernel(arguments).front(), 1.0f);
}

TEST_P(SpecialValuesTest, CompileForTheWeb) {
    try {
        const KernelProgram kernel(web, "im_exp(a) + im_pow(a, b) + im_sin(a)");
        const Arguments arguments[] = {{0, 1}};
        EXPECT_EQ(kernel(arguments).front(), 1.0f);
    } catch (const gpu::CompileError& error) {
        if (error.log().find("300 es") != std::string::npos ||
            error.log().find("GLSL 3.00 ES is not supported") != std::string::npos)
            GTEST_SKIP() << error.log();
        throw;
    }
}

} // namespace
} // namespace isomotion::kernels::special_values_test
