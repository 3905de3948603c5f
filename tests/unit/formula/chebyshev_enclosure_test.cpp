// Ranges of T_n and its derivatives against MPFR.
#include "formula/interval/chebyshev_enclosure.h"

#include <algorithm>
#include <cmath>

#include "formula/graph/lowering.h"
#include "random_interval.h"
#include "thorough.h"

namespace isomotion::formula {
namespace {

Exact extremum(int n, int j) { return apply(Op::cos, Exact(j) * Exact::pi() / Exact(n)); }

// Intervals about the unit interval, long and short ones, some with ends at extrema of T_n.
Interval near_unit(Random& random, int n) {
    const auto end = [&] {
        if (random.below(4) == 0) return extremum(n, random.below(n + 1)).rounded();
        return random.below(4) == 0 ? random.in(0.99, 1.05) : random.in(-1.02, 1.02);
    };
    const double a = end();
    const double b = random.below(2) == 0 ? end() : a + std::exp2(random.in(-53, -2));
    return {std::min(a, b), std::max(a, b)};
}

// Where T_n is extreme, 200 bits are not enough to stay below 1.
bool holds_all_but_rounding(Interval result, const Exact& value) {
    const Exact rounding = (apply(Op::abs, value) + Exact(1)) * Exact(0x1p-150);
    return holds(result, value) || holds(result, value - rounding) ||
           holds(result, value + rounding);
}

TEST(ChebyshevEnclosure, EnclosesDerivatives) {
    constexpr std::uint64_t seed = 80;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator intervals(seed);
    Random random(seed);
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 14, 25, 31, 50, 64, 101, 200}) {
        for (int k = 0; k <= 3; ++k) {
            const ChebyshevEnclosure enclose(n, k);
            for (int trial = 0; trial < trials(7'000, 20'000) / (n + 40); ++trial) {
                const Interval a = trial % 2 == 0 ? intervals.interval() : near_unit(random, n);
                const Interval result = enclose(a);
                for (int member = 0; member < 4; ++member) {
                    Exact x = intervals.member(a);
                    if (member == 3) { // an extremum of T_n, if one is inside
                        x = extremum(n, random.below(n + 1));
                        if (!holds(a, x)) continue;
                    }
                    ASSERT_TRUE(holds_all_but_rounding(result, chebyshev(n, k, x)))
                        << n << ' ' << k << ' ' << testing::PrintToString(a) << " at " << x << ": "
                        << testing::PrintToString(result) << " lacks " << chebyshev(n, k, x);
                }
            }
        }
    }
}

TEST(ChebyshevEnclosure, EnclosesTheHighestDegree) {
    constexpr std::uint64_t seed = 81;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    IntervalGenerator members(seed);
    for (const int n : {999, 1000}) {
        const ChebyshevEnclosure value(n, 0), slope(n, 1);
        for (int trial = 0; trial < 100; ++trial) {
            const Interval a = near_unit(random, n);
            const Exact x = members.member(a);
            ASSERT_TRUE(holds_all_but_rounding(value(a), chebyshev(n, 0, x)))
                << testing::PrintToString(a);
            ASSERT_TRUE(holds(slope(a), chebyshev(n, 1, x))) << testing::PrintToString(a);
        }
    }
}

// The doubles between an end and the exact value, not counting what is below the precision that
// DoubleDouble has for values of size 1.
double distance(double end, const Exact& value) {
    const double exact = value.rounded(), off = std::abs(end - exact);
    return off < 1e-24 ? 0 : off / std::abs(std::nextafter(exact, infinity) - exact);
}

TEST(ChebyshevEnclosure, IsTheRange) {
    constexpr std::uint64_t seed = 82;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const int n : {2, 3, 7, 8, 14, 25, 50}) {
        const ChebyshevEnclosure enclose(n, 0);
        for (int trial = 0; trial < 500; ++trial) {
            const Interval a = near_unit(random, n);
            Exact low = chebyshev(n, 0, a.lo), high = chebyshev(n, 0, a.hi);
            if (high < low) std::swap(low, high);
            for (int j = 1; j < n; ++j) {
                if (!holds(a, extremum(n, j))) continue;
                if (j % 2 == 0) high = std::max(high, Exact(1));
                if (j % 2 != 0) low = std::min(low, Exact(-1));
            }
            const Interval result = enclose(a);
            ASSERT_LE(distance(result.lo, low), 4) << n << ' ' << testing::PrintToString(a);
            ASSERT_LE(distance(result.hi, high), 4) << n << ' ' << testing::PrintToString(a);
        }
    }
}

// The range from 400 values; parabolas through neighbouring ones say how far extrema are beyond.
TEST(ChebyshevEnclosure, IsTheRangeOfDerivatives) {
    constexpr std::uint64_t seed = 83;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const int n : {3, 4, 9, 14, 50}) {
        for (int k = 1; k <= 3; ++k) {
            const ChebyshevEnclosure enclose(n, k);
            for (int trial = 0; trial < 12; ++trial) {
                const double x = random.in(-1.01, 1), size = random.in(0, 4.0 / n);
                const Interval a{x, x + size};
                constexpr int samples = 400;
                std::vector<double> values;
                for (int i = 0; i <= samples; ++i)
                    values.push_back(chebyshev(n, k, a.lo + (a.hi - a.lo) * i / samples).rounded());
                const auto [low, high] = std::minmax_element(values.begin(), values.end());
                double beyond = 1e-14 * (std::abs(*low) + std::abs(*high));
                for (int i = 1; i < samples; ++i) {
                    const auto j = std::size_t(i);
                    const double bend = std::abs(values[j - 1] - 2 * values[j] + values[j + 1]);
                    beyond = std::max(beyond, bend);
                }
                const Interval result = enclose(a);
                ASSERT_LE(result.hi, *high + beyond)
                    << n << ' ' << k << ' ' << testing::PrintToString(a);
                ASSERT_GE(result.lo, *low - beyond)
                    << n << ' ' << k << ' ' << testing::PrintToString(a);
            }
        }
    }
}

TEST(ChebyshevEnclosure, IsExactForPointsAndShortIntervals) {
    constexpr std::uint64_t seed = 84;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const int n : {2, 7, 14, 50}) {
        for (int k = 0; k <= 3 && k < n; ++k) {
            const ChebyshevEnclosure enclose(n, k);
            for (int trial = 0; trial < 200; ++trial) {
                const double x = random.in(-1.1, 1.1);
                const Interval result = enclose(x);
                const double exact = chebyshev(n, k, x).rounded();
                ASSERT_LE(width(result), 0x1p-50 * std::abs(exact) + 1e-20)
                    << n << ' ' << k << ' ' << x;
            }
        }
    }
}

TEST(ChebyshevEnclosure, WholeUnitInterval) {
    for (const int n : {1, 2, 7, 14, 50, 1000}) {
        EXPECT_EQ(ChebyshevEnclosure(n, 0)({-1, 1}), Interval(-1, 1)) << n;
        if (n > 2) {
            EXPECT_EQ(ChebyshevEnclosure(n, 0)({-0.9999, 0.9999}), Interval(-1, 1)) << n;
        }
        const double square = double(n) * n;
        const Interval slope = ChebyshevEnclosure(n, 1)({-1, 1});
        EXPECT_NEAR(slope.hi, square, 1e-14 * square) << n;
        EXPECT_NEAR(slope.lo, n == 1 ? 1 : n % 2 == 0 ? -square : slope.lo, 1e-14 * square) << n;
    }
    // T_3' = 12 x^2 - 3, T_4' = 32 x^3 - 16 x, which is extreme at +-sqrt(1/6).
    EXPECT_NEAR(ChebyshevEnclosure(3, 1)({-0.5, 0.5}).lo, -3, 1e-14);
    EXPECT_NEAR(ChebyshevEnclosure(3, 1)({-0.5, 0.5}).hi, 0, 1e-14);
    const double extreme = 32 * std::sqrt(1.0 / 6) / 3;
    EXPECT_NEAR(ChebyshevEnclosure(4, 1)({-0.5, 0.5}).hi, extreme, 1e-14);
    EXPECT_NEAR(ChebyshevEnclosure(4, 1)({-0.5, 0.5}).lo, -extreme, 1e-14);
}

TEST(ChebyshevEnclosure, ConstantsAndHigherDerivatives) {
    EXPECT_NEAR(ChebyshevEnclosure(9, 9)(Interval::entire()).lo, 256.0 * 362880, 1e-6);
    EXPECT_EQ(ChebyshevEnclosure(0, 0)({-3, 5}), Interval(1.0));
    EXPECT_LE(magnitude(ChebyshevEnclosure(4, 5)({-3, 5})), 1e-300);
    const ChebyshevEnclosure eighth(12, 8);
    EXPECT_EQ(eighth({0, 2}), Interval::entire());
    const Exact peak = chebyshev(12, 8, 1);
    EXPECT_NEAR(eighth({-1, 1}).hi, peak.rounded(), 1e-13 * peak.rounded());
}

TEST(ChebyshevEnclosure, FarOut) {
    for (const int n : {2, 7, 50, 1000}) {
        for (int k = 0; k <= 2 && k < n; ++k) {
            const ChebyshevEnclosure enclose(n, k);
            EXPECT_EQ(enclose({2, infinity}).hi, infinity);
            EXPECT_GT(enclose({2, infinity}).lo, 1);
            const Interval left = enclose({-infinity, -2});
            EXPECT_EQ((n - k) % 2 == 0 ? left.hi : -left.lo, infinity);
            EXPECT_GT((n - k) % 2 == 0 ? left.lo : -left.hi, 1);
            EXPECT_EQ(enclose(1e300).hi, infinity);
            // The polynomial, and what is evaluated where arguments stop.
            const double stops = n > highest_whole_degree ? chebyshev_reach(n) : infinity;
            EXPECT_GT(enclose(1e300).lo, stops < infinity ? 1e17 : 1e100);
            if (k == 0 && stops < infinity) {
                EXPECT_LE(enclose(1e300).lo, std::cosh(n * std::acosh(stops)) * (1 + 1e-9));
            }
        }
    }
}

TEST(ChebyshevEnclosure, GrowsWithItsArgument) {
    constexpr std::uint64_t seed = 85;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator random(seed);
    Random unit(seed);
    for (const int n : {2, 5, 14, 50}) {
        for (int k = 0; k <= 2; ++k) {
            const ChebyshevEnclosure enclose(n, k);
            for (int trial = 0; trial < 500; ++trial) {
                const Interval a = trial % 2 == 0 ? random.interval() : near_unit(unit, n);
                const Interval part = random.part(a);
                ASSERT_TRUE(contains(enclose(a), enclose(part)))
                    << n << ' ' << k << ' ' << testing::PrintToString(std::pair(a, part));
            }
        }
    }
}

} // namespace
} // namespace isomotion::formula
