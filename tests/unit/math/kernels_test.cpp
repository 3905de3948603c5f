// Every kernel of shaders/math against double precision, on every back end.

#include "kernel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace isomotion::kernels {
namespace {

using gpu::EveryBackend;
using std::numbers::pi;

constexpr std::size_t samples = std::size_t(1) << 18;

unsigned seed() {
    const char* given = std::getenv("ISOMOTION_SEED");
    return given ? unsigned(std::strtoul(given, nullptr, 10)) : 20260u;
}

enum class Spread {
    even,       ///< over the values
    magnitudes, ///< over the exponents; of both signs if the range is symmetric
    pi_halves,  ///< the floats next to multiples of pi/2
};

struct Interval {
    float low = 0, high = 0;
    Spread spread = Spread::even;
};

enum class Unit { ulp, absolute };

/// Over `a` (and `b`) the kernel differs from the reference by at most `bound`.
struct Claim {
    const char* call;
    std::function<double(double, double)> reference;
    Interval a, b;
    Unit unit;
    double bound;
};

double saturated(double value) {
    return std::clamp(value, -double(saturation), double(saturation));
}

const auto exp_of = [](double a, double) { return saturated(std::exp(a)); };
const auto sinh_of = [](double a, double) { return saturated(std::sinh(a)); };
const auto cosh_of = [](double a, double) { return saturated(std::cosh(a)); };
const auto tanh_of = [](double a, double) { return std::tanh(a); };
const auto asinh_of = [](double a, double) { return std::asinh(a); };
const auto acosh_of = [](double a, double) { return a < 1 ? 0 : std::acosh(a); };
const auto erf_of = [](double a, double) { return std::erf(a); };
const auto cbrt_of = [](double a, double) { return std::cbrt(a); };
const auto log_of = [](double a, double) { return std::log(a); };
const auto pow_of = [](double a, double b) { return saturated(std::pow(a, b)); };
const auto integer_pow_of = [](double a, double b) {
    return saturated(std::pow(a, std::floor(float(b) + 0.5f)));
};
const auto sin_of = [](double a, double) { return std::sin(a); };
const auto cos_of = [](double a, double) { return std::cos(a); };
const auto tan_of = [](double a, double) { return saturated(std::tan(a)); };
const auto asin_of = [](double a, double) { return std::asin(std::clamp(a, -1.0, 1.0)); };
const auto acos_of = [](double a, double) { return std::acos(std::clamp(a, -1.0, 1.0)); };
const auto atan_of = [](double a, double) { return std::atan(a); };
const auto atan2_of = [](double a, double b) { return std::atan2(a == 0 ? 0 : a, b); };
const auto sqrt_of = [](double a, double) { return std::sqrt(std::max(a, 0.0)); };
const auto divide_of = [](double a, double b) { return saturated(a / b); };

constexpr auto by_size = Spread::magnitudes;
constexpr auto next_to_pi_halves = Spread::pi_halves;

// Bounds are the worst value measured times about 1.5.
const Claim claims[] = {
    {"im_exp(a)", exp_of, {-1, 1}, {}, Unit::ulp, 1.25},
    {"im_exp(a)", exp_of, {-90, 75}, {}, Unit::ulp, 1.4},
    {"im_exp(a)", exp_of, {-1e38f, 1e38f, by_size}, {}, Unit::ulp, 1.4},
    {"im_sinh(a)", sinh_of, {-1.5f, 1.5f}, {}, Unit::ulp, 2.3},
    {"im_sinh(a)", sinh_of, {-75, 75}, {}, Unit::ulp, 2.3},
    {"im_sinh(a)", sinh_of, {-1e38f, 1e38f, by_size}, {}, Unit::ulp, 2.3},
    {"im_cosh(a)", cosh_of, {-75, 75}, {}, Unit::ulp, 2},
    {"im_tanh(a)", tanh_of, {-12, 12}, {}, Unit::ulp, 2},
    {"im_tanh(a)", tanh_of, {-1e38f, 1e38f, by_size}, {}, Unit::ulp, 2},
    {"im_asinh(a)", asinh_of, {-4, 4}, {}, Unit::ulp, 3.2},
    {"im_asinh(a)", asinh_of, {-1e-3f, 1e-3f}, {}, Unit::ulp, 3.2},
    {"im_asinh(a)", asinh_of, {-3.4e38f, 3.4e38f, by_size}, {}, Unit::ulp, 3.2},
    {"im_acosh(a)", acosh_of, {-1, 4}, {}, Unit::ulp, 4.4},
    {"im_acosh(a)", acosh_of, {1, 1.01f}, {}, Unit::ulp, 4.4},
    {"im_acosh(a)", acosh_of, {1, 3.4e38f, by_size}, {}, Unit::ulp, 3.2},
    {"im_erf(a)", erf_of, {-5, 5}, {}, Unit::ulp, 2.3},
    {"im_erf(a)", erf_of, {-1e38f, 1e38f, by_size}, {}, Unit::ulp, 2.3},
    {"im_cbrt(a)", cbrt_of, {-10, 10}, {}, Unit::ulp, 1.6},
    {"im_cbrt(a)", cbrt_of, {-3.4e38f, 3.4e38f, by_size}, {}, Unit::ulp, 1.6},
    {"im_log(a)", log_of, {0.5f, 2}, {}, Unit::ulp, 1.25},
    {"im_log(a)", log_of, {0.999f, 1.001f}, {}, Unit::ulp, 0.75},
    {"im_log(a)", log_of, {1.2e-38f, 3.4e38f, by_size}, {}, Unit::ulp, 1.25},
    {"im_pow(a, b)", pow_of, {0.01f, 10}, {-8, 8}, Unit::ulp, 1.7},
    {"im_pow(a, b)", pow_of, {1.1f, 1.3f}, {190, 210}, Unit::ulp, 3.7},
    {"im_pow(a, b)", pow_of, {0.5f, 2}, {-120, 120}, Unit::ulp, 5},
    {"im_pow(a, b)", pow_of, {1e-37f, 1e37f, by_size}, {-3, 3}, Unit::ulp, 1.7},
    {"im_pow(a, floor(b + 0.5))", integer_pow_of, {-4, 4}, {-12, 12}, Unit::ulp, 1.7},
    {"im_sin(a)", sin_of, {-3.2f, 3.2f}, {}, Unit::absolute, 1e-7},
    {"im_sin(a)", sin_of, {-1e-3f, 1e-3f}, {}, Unit::ulp, 0.75},
    {"im_sin(a)", sin_of, {-1e5f, 1e5f}, {}, Unit::absolute, 1e-7},
    {"im_sin(a)", sin_of, {-1e5f, 1e5f, next_to_pi_halves}, {}, Unit::absolute, 5e-8},
    {"im_cos(a)", cos_of, {-3.2f, 3.2f}, {}, Unit::absolute, 1e-7},
    {"im_cos(a)", cos_of, {-1e5f, 1e5f}, {}, Unit::absolute, 1.2e-7},
    {"im_cos(a)", cos_of, {-1e5f, 1e5f, next_to_pi_halves}, {}, Unit::absolute, 5e-8},
    {"im_tan(a)", tan_of, {-1.5f, 1.5f}, {}, Unit::ulp, 4},
    {"im_tan(a)", tan_of, {-1e3f, 1e3f, next_to_pi_halves}, {}, Unit::ulp, 75},
    {"im_asin(a)", asin_of, {-1.01f, 1.01f}, {}, Unit::ulp, 1.7},
    {"im_acos(a)", acos_of, {-1.01f, 1.01f}, {}, Unit::absolute, 2e-7},
    {"im_acos(a)", acos_of, {0.9f, 1.01f}, {}, Unit::ulp, 1.7},
    {"im_atan(a)", atan_of, {-4, 4}, {}, Unit::ulp, 2.6},
    {"im_atan(a)", atan_of, {-1e37f, 1e37f, by_size}, {}, Unit::ulp, 2.6},
    {"im_atan2(a, b)", atan2_of, {-4, 4}, {-4, 4}, Unit::ulp, 2.9},
    {"im_atan2(a, b)",
     atan2_of,
     {-1e37f, 1e37f, by_size},
     {-1e37f, 1e37f, by_size},
     Unit::ulp,
     2.9},
    {"im_atan2(a, b)", atan2_of, {-1e-3f, 1e-3f}, {-4, 4}, Unit::ulp, 2.9},
    {"im_sqrt(a)", sqrt_of, {-1, 100}, {}, Unit::ulp, 0.5},
    {"im_sqrt(a)", sqrt_of, {1.2e-38f, 3.4e38f, by_size}, {}, Unit::ulp, 0.5},
    {"im_divide(a, b)", divide_of, {-1e37f, 1e37f, by_size}, {-10, 10}, Unit::ulp, 0.5},
};

float next_to_a_pi_half(double low, double high, std::mt19937& random) {
    const double half = pi / 2;
    std::uniform_int_distribution<int> multiple(int(std::ceil(low / half)), int(high / half));
    std::uniform_int_distribution<int> neighbour(-2, 2);
    auto value = float(multiple(random) * half);
    for (int steps = neighbour(random); steps != 0; steps += steps < 0 ? 1 : -1)
        value = std::nextafter(value, steps < 0 ? -1e30f : 1e30f);
    return value;
}

float of_any_magnitude(float low, float high, std::mt19937& random) {
    const bool symmetric = low < 0;
    const auto first = std::bit_cast<std::uint32_t>(symmetric ? 1.2e-38f : low);
    std::uniform_int_distribution<std::uint32_t> bits(first, std::bit_cast<std::uint32_t>(high));
    const auto value = std::bit_cast<float>(bits(random));
    return symmetric && (random() & 1) ? -value : value;
}

float sample(const Interval& interval, std::mt19937& random) {
    switch (interval.spread) {
    case Spread::even:
        return std::uniform_real_distribution<float>(interval.low, interval.high)(random);
    case Spread::magnitudes:
        return of_any_magnitude(interval.low, interval.high, random);
    case Spread::pi_halves:
        break;
    }
    return next_to_a_pi_half(interval.low, interval.high, random);
}

std::vector<Arguments> arguments_for(const Claim& claim, std::mt19937& random) {
    // The ends and what is special inside come first.
    std::vector<Arguments> arguments;
    for (const float a : {claim.a.low, claim.a.high, 0.0f, -0.0f, 0.5f, -0.5f, 1.0f, -1.0f, 2.0f,
                          69.0775528f, -87.3365447f, 0.99999994f, 1.00000012f})
        for (const float b : {claim.b.low, claim.b.high, 1.0f})
            if (a >= claim.a.low && a <= claim.a.high && b >= claim.b.low && b <= claim.b.high)
                arguments.push_back({a, b});
    while (arguments.size() < samples)
        arguments.push_back({sample(claim.a, random), sample(claim.b, random)});
    return arguments;
}

/// By how much a result is off, counting a flush to zero of what is too small for a normal float
/// as right.
double error_of(float result, double reference, Unit unit) {
    if (std::isnan(reference)) return std::isnan(result) ? 0 : INFINITY;
    if (std::abs(reference) < std::numeric_limits<float>::min() && result == 0) return 0;
    const double difference = std::abs(double(result) - reference);
    if (std::isnan(difference)) return INFINITY;
    return unit == Unit::ulp ? difference / ulp(reference) : difference;
}

class KernelsTest : public EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(KernelsTest);

TEST_P(KernelsTest, KeepTheirBounds) {
    const Prelude& prelude = context->info().major >= 4 ? desktop_450 : desktop_330;
    std::mt19937 random(seed());
    std::printf("seed %u (ISOMOTION_SEED), %zu samples a row\n", seed(), samples);
    for (const Claim& claim : claims) {
        const KernelProgram kernel(prelude, claim.call);
        const auto arguments = arguments_for(claim, random);
        const auto results = kernel(arguments);
        double worst = 0;
        std::size_t where = 0;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const double reference = claim.reference(arguments[i].a, arguments[i].b);
            const double error = error_of(results[i], reference, claim.unit);
            if (error > worst) {
                worst = error;
                where = i;
            }
        }
        std::printf("%-26s a %9.3g .. %-9.3g %-3s worst %8.3g of %8.3g at a = %.9g, b = %.9g\n",
                    claim.call, double(claim.a.low), double(claim.a.high),
                    claim.unit == Unit::ulp ? "ulp" : "abs", worst, claim.bound,
                    double(arguments[where].a), double(arguments[where].b));
        EXPECT_LE(worst, claim.bound)
            << claim.call << " at a = " << arguments[where].a << ", b = " << arguments[where].b
            << " gives " << results[where] << ", not "
            << claim.reference(arguments[where].a, arguments[where].b);
    }
}

TEST_P(KernelsTest, SineAndCosineStayBoundedFarOut) {
    std::mt19937 random(seed());
    std::vector<Arguments> arguments(samples);
    for (Arguments& argument : arguments) argument.a = of_any_magnitude(-3.4e38f, 3.4e38f, random);
    const std::pair<const char*, std::function<double(double, double)>> kernels[] = {
        {"im_sin(a)", sin_of}, {"im_cos(a)", cos_of}};
    for (const auto& [call, reference] : kernels) {
        const auto results = KernelProgram(desktop_330, call)(arguments);
        for (std::size_t i = 0; i < results.size(); ++i) {
            const double a = arguments[i].a;
            ASSERT_LE(std::abs(results[i]), 1.0f) << call << " at " << a;
            if (std::abs(a) > 1e6) continue;
            ASSERT_LE(std::abs(results[i] - reference(a, 0)), 1e-7 + 2 * ulp(a))
                << call << " at " << a;
        }
    }
}

} // namespace
} // namespace isomotion::kernels
