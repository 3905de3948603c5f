// Smoothstep and its inverse, as enclosures.
#include "topology/field/easing.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace isomotion::topology {
namespace {

using formula::Interval;

TEST(Easing, EnclosesTheWayAndItsInverse) {
    std::mt19937 random(1);
    for (int draw = 0; draw < 500; ++draw) {
        const auto number = [&](double low, double high) {
            return low + (high - low) * double(random()) / 0x1p32;
        };
        const double from = number(-3, 3), length = number(0.01, 5);
        const Easing easing{from, from + length, {from, from + length}};
        const double u = number(0, 1), at = from + u * length;
        const Interval way = easing.way(Interval(at));
        EXPECT_NEAR(mid(way), u * u * (3 - 2 * u), 1e-13);
        EXPECT_LT(width(way), 1e-12);
        const Interval time = easing.time(way);
        EXPECT_TRUE(contains(time, at)) << "draw " << draw;
        // sin(3a) = 3 sin(a) - 4 sin(a)^3
        const double made = number(0, 1);
        const double inverse = 0.5 - std::sin(std::asin(1 - 2 * made) / 3);
        EXPECT_NEAR(mid(easing.time(Interval(made))), from + inverse * length, 1e-7 * length);
    }
}

TEST(Easing, IsAsLongAsItsKeys) {
    const Easing easing{1, 3, {1, 3}};
    EXPECT_EQ(easing.way({1, 3}), Interval(0, 1));
    EXPECT_EQ(easing.time({-1e-15, 1 + 1e-15}), Interval(1, 3));
    // Near a key a little of the way takes long.
    const Interval first = easing.time({-1e-15, 1e-15});
    EXPECT_EQ(first.lo, 1);
    EXPECT_GT(first.hi, 1 + 2 * std::sqrt(1e-15 / 3));
    EXPECT_LT(first.hi, 1 + 1e-7);
    const Interval last = easing.time({1 - 1e-15, 1});
    EXPECT_LT(last.lo, 3 - 2 * std::sqrt(1e-15 / 3));
    EXPECT_EQ(last.hi, 3);
}

} // namespace
} // namespace isomotion::topology
