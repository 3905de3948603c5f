// Chmutov surfaces of order 12 to 50: T_n(x) + T_n(y) + T_n(z) + c by the recurrence, which is what
// chebyshev() does, by cosines and in powers. All have the same points and differ in rounding.
#include "scenes/hard_case.h"

#include <cmath>

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

enum class Form { recurrence, cosines, powers };

// T_n in powers of x by Horner's scheme in x^2, n even; the coefficients are exact in double until
// n = 40 or so, rounded to float they are not.
std::string in_powers(int n, const std::string& x) {
    std::vector<double> coefficients{1}; // of T_k in falling powers, every second one
    // a_k = (-1)^k n/2 * (n-k-1)! / (k! (n-2k)!) * 2^(n-2k)
    coefficients[0] = std::ldexp(1.0, n - 1);
    for (int k = 1; 2 * k <= n; ++k) {
        const double ratio = -double(n - 2 * k + 2) * double(n - 2 * k + 1) / (4.0 * k * (n - k));
        coefficients.push_back(std::round(coefficients.back() * ratio));
    }
    std::string text = fmt::format("{:.17g}", coefficients[0]);
    for (std::size_t k = 1; k < coefficients.size(); ++k) {
        text = fmt::format("({})*{}^2 + {:.17g}", text, x, coefficients[k]);
    }
    return text;
}

std::string term(int n, Form form, const std::string& x) {
    switch (form) {
    case Form::recurrence:
        return fmt::format("chebyshev({}, {})", n, x);
    // cos inside [-1, 1] and cosh outside: each is 1 where the other counts.
    case Form::cosines:
        return fmt::format("cos({0}*acos(min(abs({1}), 1)))*cosh({0}*log(max(1, abs({1})) + "
                           "sqrt((max(1, abs({1})) - 1)*(max(1, abs({1})) + 1))))",
                           n, x);
    case Form::powers:
        return in_powers(n, x);
    }
    return {};
}

// An eighth of the paper's step, so that what is wrong comes from rounding.
std::string chmutov(int n, Form form) {
    const scene::Scene from = render::scene_of(fmt::format("[surface]\nuse = 'chmutov_{}'\n", n));
    const scene::Isolation& isolation = from.surfaces[0].isolation;
    const scene::SceneAt now = scene::at_frame(from, 1);
    return fmt::format("[surface]\nformula = \"{} + {} + {} + c\"\nbounds = {{ box = [[{}, {}, "
                       "{}], [{}, {}, {}]] }}\n"
                       "[parameters]\nc = 0\n"
                       "[isolation]\nstep = {}\nnear = {}\nfar = {}\nhorizon = {}\n",
                       term(n, form, "x"), term(n, form, "y"), term(n, form, "z"),
                       now.surfaces[0].bounds.min.x, now.surfaces[0].bounds.min.y,
                       now.surfaces[0].bounds.min.z, now.surfaces[0].bounds.max.x,
                       now.surfaces[0].bounds.max.y, now.surfaces[0].bounds.max.z,
                       isolation.step / 8, isolation.near, isolation.far, isolation.horizon);
}

struct HighDegree {
    int n;
    double recurrence, cosines, powers; // wrong ppm of the sign test
    double powers_by_default = 0; // float32 has lost the sum: terms are 10^5 and more times it
};
void PrintTo(const HighDegree& degree, std::ostream* out) { *out << degree.n; }

class Degree : public testing::TestWithParam<HighDegree> {};

TEST_P(Degree, OfTheThreeFormsTheRecurrenceHolds) {
    const HighDegree& degree = GetParam();
    const std::string truth = chmutov(degree.n, Form::recurrence);
    const auto a_case = [&](const char* name, Form form, double most, double by_default = 0) {
        return HardCase{fmt::format("Chmutov {} {}", degree.n, name),
                        chmutov(degree.n, form),
                        {{Method::amp_sign, most}},
                        truth,
                        by_default,
                        /*is_cut_off=*/by_default > 0};
    };
    expect_bounds(a_case("recurrence", Form::recurrence, degree.recurrence));
    expect_bounds(a_case("cosines", Form::cosines, degree.cosines));
    expect_bounds(a_case("powers", Form::powers, degree.powers, degree.powers_by_default));
}

INSTANTIATE_TEST_SUITE_P(Stability, Degree,
                         testing::Values(HighDegree{12, 0, 0, 0}, HighDegree{14, 0, 0, 0},
                                         HighDegree{18, 0, 0, 6000, 9000},
                                         HighDegree{22, 0, 0, 110000, 110000},
                                         HighDegree{50, 390, 390, 78000, 120000}),
                         testing::PrintToStringParamName());

} // namespace
} // namespace isomotion::stability
