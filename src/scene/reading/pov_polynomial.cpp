#include "scene/reading/pov_polynomial.h"

#include <cmath>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

// `b` is the power of POV-Ray's y, which is our z.
void add_term(const PovNumber& factor, int a, int b, int c, std::string& sum) {
    if (factor.value == 0.0) return;
    const auto plain = factor.plain();
    std::string term =
        plain ? fmt::format("{}", std::abs(*plain)) : fmt::format("({})", factor.text);
    const bool is_negative = plain && *plain < 0;
    // "x^2", not "1*x^2".
    if (plain && std::abs(*plain) == 1 && a + b + c > 0) term.clear();
    const auto multiply = [&](char name, int power) {
        if (power == 1) term += fmt::format("{}{}", term.empty() ? "" : "*", name);
        if (power > 1) term += fmt::format("{}{}^{}", term.empty() ? "" : "*", name, power);
    };
    multiply('x', a);
    multiply('z', b);
    multiply('y', c);
    if (!sum.empty())
        sum += is_negative ? " - " : " + ";
    else if (is_negative)
        sum += "-";
    sum += term;
}

} // namespace

std::string pov_polynomial(PovCursor& at, PovValues& values, int order, std::string_view key) {
    at.expect("<", key);
    const int count = (order + 1) * (order + 2) * (order + 3) / 6;
    std::string sum;
    bool is_first = true;
    for (int a = order; a >= 0; --a) {
        for (int b = order - a; b >= 0; --b) {
            for (int c = order - a - b; c >= 0; --c) {
                if (!is_first) at.take_if(",");
                if (at.now().is(">")) at.fail(key, fmt::format("needs {} numbers", count));
                is_first = false;
                add_term(values.number(at, key), a, b, c, sum);
            }
        }
    }
    if (!at.now().is(">")) at.fail(key, fmt::format("has more than {} numbers", count));
    at.take();
    return sum.empty() ? "0" : sum;
}

std::string pov_quadric(PovCursor& at, PovValues& values) {
    static constexpr int powers[9][3] = {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1},
                                         {0, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::string sum;
    for (int group = 0; group < 3; ++group) {
        const PovValue factors = values.vector(at, "quadric");
        for (int k = 0; k < 3; ++k) {
            const auto& power = powers[3 * group + k];
            add_term(factors[std::size_t(k)], power[0], power[1], power[2], sum);
        }
        at.take_if(",");
    }
    add_term(values.number(at, "quadric"), 0, 0, 0, sum);
    return sum.empty() ? "0" : sum;
}

} // namespace isomotion::scene
