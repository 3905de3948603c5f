// Boxes over which intervals take a formula for smooth.
#include "formula/graph/roughness.h"

#include <array>

#include <gtest/gtest.h>

#include "formula/enclosure.h"
#include "unit/formula/testing.h"

namespace isomotion::formula {
namespace {

bool is_rough(const char* formula, const Interval& x) {
    const Field field = make_field(formula, test_vocabulary());
    const Program program = enclosure_programs(field).rough;
    const std::array<Interval, 3> box{x, Interval(1), Interval(1)};
    std::array<Interval, 2> found;
    Evaluator<Interval>(program).point(convert<Interval>(test_bindings()), box, found);
    return !(found[1] == Interval(0));
}

TEST(Rough, KinksJumpsAndPolesAreInTheirBoxesAlone) {
    const Interval across{-1, 1}, above{1, 1.4};
    for (const char* formula : {"abs(x)", "max(x, 0*y)", "floor(x)", "1/x", "sqrt(x)", "log(x)",
                                "x^0.5", "x^-2", "tan(1.7*x)", "sign(x)"}) {
        EXPECT_TRUE(is_rough(formula, across)) << formula;
    }
    for (const char* formula : {"abs(x)", "1/x", "sqrt(x)", "log(x)", "x^0.5", "x^-2", "sign(x)"})
        EXPECT_FALSE(is_rough(formula, above)) << formula;
    for (const char* formula : {"x^3 - y", "exp(x)*z", "sin(x)", "max(0, x)^3", "1/(2 + x^2)"})
        EXPECT_FALSE(is_rough(formula, across)) << formula;
}

// (x^2 - y^2)/(x^2 + y^2) turns about its axis without a pole on most rays.
TEST(Rough, QuotientsAreWhereTheirDenominatorsComeToHalfOfThemselves) {
    for (const char* formula : {"y/x", "1/(x*y)", "(x - y)/-x"}) {
        EXPECT_FALSE(is_rough(formula, {1, 1.9})) << formula;
        EXPECT_FALSE(is_rough(formula, {-1.9, -1})) << formula;
        EXPECT_TRUE(is_rough(formula, {1, 2.1})) << formula;
        EXPECT_TRUE(is_rough(formula, {-1, -0.01})) << formula;
        EXPECT_FALSE(is_rough(formula, {1e-20, 1.9e-20})) << formula << " small itself";
    }
}

// An angle turns about its axis where the denominator stays the same, too.
TEST(Rough, AnglesAreWhereTheirSlopeComesToHalfOfItself) {
    EXPECT_FALSE(is_rough("atan(x/y)", {-0.9, 0.9}));
    EXPECT_FALSE(is_rough("atan(x/y)", {10, 14}));
    EXPECT_TRUE(is_rough("atan(x/y)", {-1.1, 0}));
    EXPECT_TRUE(is_rough("atan(x/y)", {10, 15}));
    EXPECT_FALSE(is_rough("atan(9*x)", {-9, 9}));
    EXPECT_FALSE(is_rough("atan(x/9)", {-90, 90}));
}

} // namespace
} // namespace isomotion::formula
