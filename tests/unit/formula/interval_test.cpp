#include "formula/interval/interval.h"

#include <bit>

#include "random_interval.h"

namespace isomotion::formula {
namespace {

const Interval all = Interval::entire();

TEST(Interval, StandsForItsMembers) {
    EXPECT_EQ(Interval(), Interval(0, 0));
    EXPECT_EQ(Interval(2.5), Interval(2.5, 2.5));
    EXPECT_EQ(Interval(std::nan("")), all);
    EXPECT_EQ(Interval(infinity), Interval(largest_finite, infinity));
    EXPECT_EQ(Interval(-infinity), Interval(-infinity, -largest_finite));
    EXPECT_TRUE(contains({1, 2}, 2.0));
    EXPECT_FALSE(contains({1, 2}, 2.5));
    EXPECT_TRUE(contains(Interval(1, infinity), Interval(1, 5)));
    EXPECT_FALSE(contains(Interval(1, 5), Interval(1, infinity)));
    EXPECT_EQ(hull({1, 2}, {4, 5}), Interval(1, 5));
    EXPECT_EQ(intersect({1, 4}, {2, 5}), Interval(2, 4));
    EXPECT_TRUE(is_empty(intersect({1, 2}, {4, 5})));
    EXPECT_FALSE(is_empty(intersect({1, 2}, {2, 5})));
    EXPECT_EQ(magnitude({-3, 2}), 3);
    EXPECT_EQ(mignitude({-3, 2}), 0);
    EXPECT_EQ(mignitude({-3, -2}), 2);
}

TEST(Interval, MidIsAMember) {
    EXPECT_EQ(mid({1, 4}), 2.5);
    EXPECT_EQ(mid(all), 0);
    EXPECT_EQ(mid({largest_finite, largest_finite}), largest_finite);
    EXPECT_EQ(mid(smallest_positive), smallest_positive);
    IntervalGenerator random(50);
    for (int trial = 0; trial < 20'000; ++trial) {
        const Interval a = random.interval();
        ASSERT_TRUE(contains(a, mid(a)) && std::isfinite(mid(a))) << testing::PrintToString(a);
    }
}

TEST(Interval, WidthIsNoLess) {
    EXPECT_EQ(width(7.0), 0);
    EXPECT_EQ(width({1, infinity}), infinity);
    EXPECT_EQ(width({-largest_finite, largest_finite}), infinity);
    IntervalGenerator random(51);
    for (int trial = 0; trial < 20'000; ++trial) {
        const Interval a = random.interval();
        if (a.lo == -infinity || a.hi == infinity) continue;
        const Exact exact = Exact(a.hi) - Exact(a.lo);
        ASSERT_FALSE(Exact(width(a)) < exact) << testing::PrintToString(a);
    }
}

// The next double or the one after it: never none, for any double that a sum may be rounded to.
TEST(Rounding, GoesOneOrTwoDoublesOut) {
    constexpr std::uint64_t seed = 52;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 bits(seed);
    for (int trial = 0; trial < 200'000; ++trial) {
        // All exponents alike; mantissas of few bits, to have powers of two and their neighbours.
        const std::uint64_t mantissa = bits() >> 12;
        const std::uint64_t exponent = bits() % 2046 + (trial % 4 == 0 ? 0 : 1);
        const std::uint64_t pattern = trial % 3 == 0   ? mantissa
                                      : trial % 3 == 1 ? mantissa & 3
                                                       : (1ull << 52) - 1 - (mantissa & 3);
        const double r = std::bit_cast<double>(exponent << 52 | pattern);
        if (r < 0x1p-1021) continue; // sums are exact there
        const double next = std::nextafter(r, infinity), last = std::nextafter(r, 0);
        EXPECT_GE(round_up(r), next) << r;
        EXPECT_LE(round_up(r), std::nextafter(next, infinity)) << r;
        EXPECT_LE(round_down(r), last) << r;
        // Just above a power of two doubles are half as far apart below.
        EXPECT_GE(round_down(r), r - 2 * (next - r)) << r;
        EXPECT_EQ(round_down(-r), -round_up(r));
        EXPECT_EQ(round_up(-r), -round_down(r));
    }
}

TEST(Rounding, AtTheEnds) {
    EXPECT_EQ(round_down(0), 0);
    EXPECT_EQ(round_up(0), 0);
    EXPECT_EQ(round_up(0, smallest_positive), smallest_positive);
    EXPECT_EQ(round_up(largest_finite), infinity);
    EXPECT_LE(round_down(infinity), largest_finite);
    EXPECT_GT(round_down(infinity), 0.99 * largest_finite);
    EXPECT_EQ(round_down(-infinity), -infinity);
}

TEST(IntervalArithmetic, KnownValues) {
    EXPECT_EQ(square({-1, 2}).lo, 0);
    EXPECT_NEAR(square({-1, 2}).hi, 4, 1e-15);
    EXPECT_NEAR((Interval(-1, 2) * Interval(-1, 2)).lo, -2, 1e-15);
    EXPECT_EQ(-Interval(-1, 2), Interval(-2, 1));
    EXPECT_EQ(Interval(0.0) + Interval(0.0), Interval(0.0));
    EXPECT_EQ(all + Interval(1.0), all);
    EXPECT_EQ(all - all, all);
}

TEST(IntervalArithmetic, NothingTimesAnything) {
    const Interval none = 0.0;
    for (const Interval a :
         {all, Interval(1, infinity), Interval(-infinity, -1), Interval(-1, 1)}) {
        for (const Interval product : {none * a, a * none}) {
            EXPECT_TRUE(contains(product, 0.0));
            EXPECT_LE(magnitude(product), smallest_positive);
        }
    }
    EXPECT_EQ(Interval(0, 1) * Interval(1, infinity), Interval(0, infinity));
    EXPECT_EQ(Interval(-1, 1) * all, all);
}

// Sums and products of what isn't negative can be divided by.
TEST(IntervalArithmetic, RoundingDoesNotCrossZero) {
    const Interval some{0, 2}, tiny{1e-200, 2e-200};
    EXPECT_EQ((some * some).lo, 0);
    EXPECT_EQ((some * -some).hi, 0);
    EXPECT_EQ((-some * -some).lo, 0);
    EXPECT_EQ((tiny * tiny).lo, 0);
    EXPECT_EQ(square(tiny).lo, 0);
    EXPECT_GT(square(tiny).hi, 0);
    EXPECT_EQ((square(some) + square(some)).lo, 0);
    EXPECT_EQ((some / Interval(1, 2)).lo, 0);
    EXPECT_EQ((tiny / Interval(1e200)).lo, 0);
    EXPECT_LT((tiny * Interval(-1e-200, 1e-200)).lo, 0);
}

TEST(IntervalArithmetic, DivisorsThatHoldZero) {
    EXPECT_EQ(Interval(1, 2) / Interval(-1, 1), all);
    EXPECT_EQ(Interval(1, 2) / Interval(-1, 0), all); // 1/0 is +10^300
    EXPECT_EQ(Interval(0, 2) / Interval(0, 1), all);  // 0/0
    EXPECT_EQ(Interval(0.0) / Interval(0.0), all);
    const Interval up = Interval(1, 2) / Interval(0, 4);
    EXPECT_NEAR(up.lo, 0.25, 1e-15);
    EXPECT_EQ(up.hi, infinity);
    const Interval down = Interval(-2, -1) / Interval(-0.0, 4);
    EXPECT_NEAR(down.hi, -0.25, 1e-15);
    EXPECT_EQ(down.lo, -infinity);
    EXPECT_GT((Interval(1, 2) / Interval(0.0)).lo, 1e300);
    EXPECT_EQ(all / Interval(1, infinity), all);
    EXPECT_EQ((Interval(1, infinity) / Interval(1, infinity)).lo, 0);
}

// Fewer comparisons, the same ends.
TEST(IntervalArithmetic, KnownSignsDoNotChangeProducts) {
    constexpr std::uint64_t seed = 57;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator random(seed);
    int not_negative = 0, neither_is = 0, numbers = 0;
    for (int trial = 0; trial < 200'000; ++trial) {
        const Interval a = random.interval(), b = random.interval();
        SCOPED_TRACE(testing::PrintToString(std::pair(a, b)));
        const Interval product = a * b;
        if (!(b.lo >= 0 && b.hi > 0)) continue;
        ++not_negative;
        ASSERT_EQ(times_not_negative(a, b), product);
        if (a.lo >= 0 && a.hi > 0) {
            ++neither_is;
            ASSERT_EQ(product_not_negative(a, b), product);
        }
        if (b.lo > 0 && is_point(b)) {
            ++numbers;
            ASSERT_EQ(times_positive(a, b.lo), product);
        }
    }
    EXPECT_GT(not_negative, 20'000);
    EXPECT_GT(neither_is, 3'000);
    EXPECT_GT(numbers, 1'000);
    for (const Interval a : {Interval(0, 0), Interval(-2, 0), Interval(-2, 3), all}) {
        EXPECT_TRUE(contains(times_not_negative(a, {0, 0}), 0.0));
        EXPECT_TRUE(contains(product_not_negative({mignitude(a), magnitude(a)}, {0, 0}), 0.0));
    }
}

} // namespace
} // namespace isomotion::formula
