// Krawczyk's operator in one variable, where all of it can be counted by hand.
#include "topology/search/krawczyk.h"

#include <gtest/gtest.h>

namespace isomotion::topology {
namespace {

using formula::Interval;

// Krawczyk's operator of x^2 - c over x.
Krawczyk of_square(Interval x, double c) {
    const double m = mid(x);
    const IntervalMatrix slopes{{{Interval(2) * x}}};
    const auto y = middle_inverse(slopes, 1);
    EXPECT_TRUE(y);
    return krawczyk({x}, {m}, {square(Interval(m)) - Interval(c)}, slopes, *y, 1);
}

TEST(Krawczyk, IsInsideAroundARootAndEmptyWhereThereIsNone) {
    const Krawczyk around = of_square({1.3, 1.5}, 2);
    EXPECT_TRUE(around.is_inside);
    EXPECT_FALSE(around.is_empty);
    EXPECT_TRUE(contains(around.image[0], 1.4142135623730951));
    EXPECT_LT(around.contraction, 1);

    const Krawczyk beside = of_square({2, 2.5}, 2);
    EXPECT_FALSE(beside.is_inside);
    EXPECT_TRUE(beside.is_empty);
}

// The root is outside, or at the wall: the image meets the box and is not in it.
TEST(Krawczyk, IsNotInsideWhereItMeetsTheBox) {
    for (const Interval x : {Interval(1.3, 1.41), Interval(1.42, 1.5), Interval(1, 1.5)}) {
        const Krawczyk meets = of_square(x, x.lo == 1 ? 1 : 2);
        EXPECT_FALSE(meets.is_inside) << x.lo;
    }
}

// With Y = 0 the image of every box is the box, whatever the function is.
TEST(Krawczyk, IsNotInsideWhereItIsTheBox) {
    const Krawczyk same = krawczyk({Interval(0)}, {0}, {Interval(5)}, {{{Interval(1)}}}, {}, 1);
    EXPECT_EQ(same.image[0], Interval(0));
    EXPECT_FALSE(same.is_inside);
}

} // namespace
} // namespace isomotion::topology
