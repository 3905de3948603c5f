#include "formula/graph/recentred.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "formula/evaluate/evaluate.h"
#include "formula/field.h"

namespace isomotion::formula {
namespace {

constexpr std::array<double, 3> origin{500000, 4649776, 120};

template<class T> T value(const Field& field, const std::array<double, 3>& p) {
    const Bindings<T> none;
    return FieldEvaluator<T>(field).value(none, {T(p[0]), T(p[1]), T(p[2])});
}

// What floats lose at large coordinates comes back: the same values as doubles have, to the digits
// of floats.
TEST(Recentred, FloatsKeepTheirDigits) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> within(-20, 20);
    for (const char* formula :
         {"(x - 500000)^2 + (y - 4649776)^2 + (z - 120)^2 - 900",
          "((x - 500010)/3)^2 + 2*abs(4649776 - y) - (120 - z)*4",
          "sin(x)*cos(2*y - 3) + tan(z/50)/10 + floor(x/7)/70000 - sin(-x)",
          "max(-x + 499990, 2*x - 1000020, y - 4649780) + 3*z - 360", "mod(x, 3) + mod(y - 1, 2.5)",
          "u = x - 500000; v = y - 4649776; u^3 - v^2*u + z - 120"}) {
        const Field far = make_field(formula, {}),
                    near = make_field(formula, {}, nullptr, {origin});
        EXPECT_EQ(near.origin.point, origin);
        for (int k = 0; k < 200; ++k) {
            const std::array<double, 3> p{within(random), within(random), within(random)};
            const double exact =
                value<double>(far, {origin[0] + p[0], origin[1] + p[1], origin[2] + p[2]});
            EXPECT_NEAR(value<double>(near, p), exact, 1e-8 * (1 + std::abs(exact)))
                << formula << " at " << p[0] << ' ' << p[1] << ' ' << p[2];
            // But beside steps.
            const double beside =
                value<double>(far, {origin[0] + p[0] + 1e-4, origin[1] + p[1], origin[2] + p[2]});
            if (std::abs(beside - exact) > 0.1) continue;
            EXPECT_NEAR(double(value<float>(near, p)), exact, 2e-5 * (30 + std::abs(exact)))
                << formula << " at " << p[0] << ' ' << p[1] << ' ' << p[2];
        }
    }
}

TEST(Recentred, LeavesNoTraceOfAShiftThatTheFormulaUndoes) {
    const Field near =
        make_field("(x - 500000)^2 + (y - 4649776)^2 + (z - 120)^2 - 900", {}, nullptr, {origin});
    const Field about_0 = make_field("x^2 + y^2 + z^2 - 900", {});
    EXPECT_EQ(near.value.instructions.size(), about_0.value.instructions.size());
    EXPECT_EQ(make_field("x^2 - 1", {}, nullptr, {}).origin.point, (std::array<double, 3>{}));
}

} // namespace
} // namespace isomotion::formula
