// Formulas that are finite on paper are finite in float and double, where users go.
#include "testing.h"

#include <cmath>
#include <limits>

#include "formula/field.h"
#include "formula/graph/operations.h"

namespace isomotion::formula::finite_test {
namespace {

template<class T> class Rules : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Rules, Numbers);

TYPED_TEST(Rules, SaturationLeavesRoomForCoefficientsAndSums) {
    using Do = Operations<TypeParam>;
    EXPECT_TRUE(std::isfinite(Do::saturation() * TypeParam(1e5)));
    EXPECT_EQ(Do::saturate(std::numeric_limits<TypeParam>::infinity()), Do::saturation());
    EXPECT_EQ(Do::saturate(-std::numeric_limits<TypeParam>::infinity()), -Do::saturation());
    EXPECT_EQ(Do::saturate(TypeParam(-3)), TypeParam(-3));
    EXPECT_TRUE(std::isnan(Do::saturate(std::numeric_limits<TypeParam>::quiet_NaN())));
}

TYPED_TEST(Rules, CutOff) {
    using Do = Operations<TypeParam>;
    const TypeParam most = Do::saturation();
    EXPECT_EQ(Do::exp(TypeParam(1e4)), most);
    EXPECT_EQ(Do::exp(TypeParam(-1e4)), 0);
    EXPECT_EQ(Do::sinh(TypeParam(-1e4)), -most);
    EXPECT_EQ(Do::cosh(TypeParam(-1e4)), most);
    EXPECT_EQ(Do::log(TypeParam(0)), -most);
    EXPECT_TRUE(std::isnan(Do::log(TypeParam(-1))));
    EXPECT_EQ(Do::divide(1, 0), most);
    EXPECT_EQ(Do::divide(-1, 0), -most);
    EXPECT_TRUE(std::isnan(Do::divide(0, 0)));
    EXPECT_EQ(Do::divide(TypeParam(1), std::numeric_limits<TypeParam>::denorm_min()), most);
    EXPECT_EQ(Do::sqrt(TypeParam(-1e-9)), 0);
    EXPECT_EQ(Do::acos(TypeParam(1.5)), 0);
    EXPECT_EQ(Do::asin(TypeParam(-2)), std::asin(TypeParam(-1)));
}

TYPED_TEST(Rules, Powers) {
    using Do = Operations<TypeParam>;
    EXPECT_EQ(Do::power(0, 0), 1);
    EXPECT_EQ(Do::power(0, TypeParam(0.3)), 0);
    EXPECT_EQ(Do::power(0, TypeParam(-0.3)), Do::saturation());
    EXPECT_EQ(Do::power(TypeParam(-0.0), -3), Do::saturation()); // one zero
    EXPECT_EQ(Do::power(-2, 3), -8);
    EXPECT_EQ(Do::power(-2, -2), TypeParam(0.25));
    EXPECT_TRUE(std::isnan(Do::power(-2, TypeParam(0.5))));
    EXPECT_EQ(Do::power(10, 1000), Do::saturation());
    EXPECT_EQ(Do::power(-10, 1001), -Do::saturation());
}

TYPED_TEST(Rules, Signs) {
    using Do = Operations<TypeParam>;
    EXPECT_EQ(Do::sign(TypeParam(-0.0)), 0);
    EXPECT_EQ(Do::sign(TypeParam(1e-40)), 1);
    EXPECT_EQ(Do::sign(TypeParam(-7)), -1);
    EXPECT_TRUE(std::isnan(Do::sign(std::numeric_limits<TypeParam>::quiet_NaN())));
}

// Value and derivatives of `text`, in both number types.
struct Seen {
    double value;
    Point gradient;
    std::array<double, 2> along;
};

template<class T> Seen see_as(std::string_view text, const Point& p, double m) {
    const Field field = make_field(text, test_vocabulary());
    Bindings<double> wide = test_bindings();
    wide.parameters[3] = m;
    const auto bindings = convert<T>(wide);
    FieldEvaluator<T> evaluator(field);
    const std::array<T, 3> q{T(p[0]), T(p[1]), T(p[2])};
    const auto g = evaluator.gradient(bindings, q);
    const auto along = evaluator.directional(bindings, q, {T(0.6), T(0), T(-0.8)});
    return {evaluator.value(bindings, q), {g[0], g[1], g[2]}, {along[0], along[1]}};
}

std::vector<Seen> see(std::string_view text, const Point& p, double m = 3) {
    return {see_as<float>(text, p, m), see_as<double>(text, p, m)};
}

void expect_finite(const Seen& seen) {
    EXPECT_TRUE(std::isfinite(seen.value)) << seen.value;
    for (const double g : seen.gradient) EXPECT_TRUE(std::isfinite(g)) << g;
    for (const double v : seen.along) EXPECT_TRUE(std::isfinite(v)) << v;
}

TEST(Finite, PowersOfAnAbsoluteValueAtZero) {
    for (const double m : {0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.3, 25.0, 50.5, 200.0}) {
        SCOPED_TRACE(m);
        for (const Point& p : {Point{0, 0, 0}, {0, 0.5, 0}, {0.5, 0, -0.5}}) {
            for (const Seen& seen : see("abs(x)^m + abs(y)^m + abs(z)^m - 1", p, m)) {
                expect_finite(seen);
                double expected = -1;
                for (const double c : p) expected += std::pow(std::abs(c), m);
                EXPECT_NEAR(seen.value, expected, 1e-6);
                if (p[0] == 0) {
                    EXPECT_EQ(seen.gradient[0], 0);
                }
            }
        }
    }
}

TEST(Finite, ConstantExponents) {
    for (const auto* text : {"abs(x)^0.3", "abs(x)^1.5", "abs(x)^200", "abs(x)^200.5", "abs(x)^1",
                             "(x^2)^0.3", "sqrt(abs(x))"}) {
        SCOPED_TRACE(text);
        for (const Seen& seen : see(text, {0, 1, 1})) {
            expect_finite(seen);
            EXPECT_EQ(seen.value, 0);
            EXPECT_EQ(seen.gradient, (Point{0, 0, 0}));
        }
    }
}

TEST(Finite, ConesOnTheirAxis) {
    for (const Seen& seen : see("(1 - sqrt(x^2+y^2))^2 + z^2 - 0.16", {0, 0, 0.5})) {
        expect_finite(seen);
        EXPECT_NEAR(seen.value, 1.09, 1e-6);
        EXPECT_EQ(seen.gradient, (Point{0, 0, 1}));
    }
    for (const Seen& seen : see("sqrt(x^2+y^2+z^2) - 1", {0, 0, 0})) {
        expect_finite(seen);
        EXPECT_EQ(seen.value, -1);
        EXPECT_EQ(seen.gradient, (Point{0, 0, 0}));
    }
}

TEST(Finite, NothingTimesSomethingHuge) {
    for (const auto* text : {"y*exp(x)", "y*exp(x^2)", "y*sinh(x)", "y*cosh(x)", "y*z^-1.5",
                             "y*x^400", "y*exp(200)", "y*log(z)", "y*10^x"}) {
        SCOPED_TRACE(text);
        for (const Seen& seen : see(text, {1000, 0, 0})) EXPECT_EQ(seen.value, 0);
    }
    for (const Seen& seen : see("y*exp(x)", {1000, 0, 0})) expect_finite(seen);
    for (const Seen& seen : see("exp(-30*(x^2+y^2))*exp(30*z)", {0, 0, 1000})) expect_finite(seen);
}

TEST(Finite, HighDegreesFarOut) {
    for (const auto* text :
         {"chebyshev(50,x)+chebyshev(50,y)+chebyshev(50,z)", "chebyshev(50,x)-chebyshev(50,y)",
          "chebyshev(200,x)-chebyshev(200,-y)", "x^200-y^200", "x^200+y^200+z^200-1",
          "max(x,z)^200-max(y,z)^200", "abs(x)^199-abs(y)^199", "x^24-y^24", "x^m-y^m"}) {
        SCOPED_TRACE(text);
        for (const Point& p : {Point{6, 6, 6}, {6, -6, 0.5}, {-6, 5, 1}, {6, 0.5, 6}}) {
            for (const Seen& seen : see(text, p, 200)) {
                // A real power of a negative number is what the author asked for, not an accident.
                const bool negative = text == std::string("x^m-y^m") && (p[0] < 0 || p[1] < 0);
                if (!negative) expect_finite(seen);
            }
        }
    }
}

// Off their poles: at |x| = 1/2 x^-200 is a pole as far as float can tell, and has no derivative.
TEST(Finite, HighNegativeDegrees) {
    for (const Point& p : {Point{6, 6, 6}, {1, -1, 1}, {-6, 1, 1}, {6, -5, 1}}) {
        for (const Seen& seen : see("x^-200 - y^-200 + chebyshev(200,z)^-1", p))
            expect_finite(seen);
    }
}

// Clamping far out may not touch the picture.
TEST(Finite, HighDegreesNearOneAreExact) {
    for (const double x : {-1.1, -1.0, -0.9, 0.5, 1.0, 1.1, 1.3}) {
        const double power = std::pow(x, 200);
        EXPECT_NEAR(value_of("x^200", {x, 0, 0}), power, 1e-13 * power) << x;
        const double t50 = std::abs(x) <= 1 ? std::cos(50 * std::acos(x))
                                            : std::cosh(50 * std::acosh(std::abs(x)));
        EXPECT_NEAR(value_of("chebyshev(50,x)", {x, 0, 0}), t50, 1e-11 * std::abs(t50) + 1e-12)
            << x;
    }
}

TEST(Finite, PolesSaturate) {
    for (const auto* text : {"1/(x^2+y^2+z^2)", "(x^2+y^2+z^2)^-1", "(x^2+y^2+z^2)^-0.5"}) {
        SCOPED_TRACE(text);
        EXPECT_EQ(see(text, {0, 0, 0})[0].value, double(Operations<float>::saturation()));
        EXPECT_EQ(see(text, {0, 0, 0})[1].value, Operations<double>::saturation());
    }
    // A thousand poles in one place still add up.
    Bindings<double> bindings = test_bindings(1000, 0);
    for (auto& column : bindings.arrays[0].fields) column.assign(1000, 0.5);
    const double sum =
        value_of("sum(blobs, 1/((x-cx)^2+(y-cy)^2+(z-cz)^2)) - 1", {0.5, 0.5, 0.5}, bindings);
    EXPECT_TRUE(std::isfinite(sum));
    EXPECT_GE(sum, 999e300);
}

TEST(Finite, ConstantsBeyondFloat) {
    for (const auto* text : {"exp(200)*x", "1e300*x", "1e39*x*y", "x/1e30"}) {
        SCOPED_TRACE(text);
        for (const Seen& seen : see(text, {0, 0, 0})) {
            EXPECT_EQ(seen.value, 0);
            expect_finite(seen);
        }
    }
}

} // namespace
} // namespace isomotion::formula::finite_test
