#include "formula/interval/double_double.h"

#include "exact.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

Exact value_of(DoubleDouble<double> a) { return Exact(a.hi) + Exact(a.lo); }

// How far a is from `exact`, as a part of its bound.
testing::AssertionResult within_bound(DoubleDouble<double> a, const Exact& exact) {
    const Exact off = apply(Op::abs, value_of(a) - exact);
    if (!(Exact(a.error) < off)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "off by " << off << ", bound " << a.error;
}

class Operands {
public:
    explicit Operands(std::uint64_t seed)
        : random_(seed) {}

    // Sizes from `least` to `most` powers of two; a low half that may be 0 or half an ulp.
    DoubleDouble<double> draw(double least, double most) {
        const double hi = random_.in(-1, 1) * std::exp2(random_.in(least, most));
        const double ulp = std::nextafter(std::abs(hi), infinity) - std::abs(hi);
        const double lo = random_.below(4) == 0 ? 0 : random_.in(-0.5, 0.5) * ulp;
        return exact_sum(hi, lo);
    }

private:
    Random random_;
};

TEST(DoubleDouble, SumsAndProductsKeepTheirBounds) {
    constexpr std::uint64_t seed = 70;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Operands operands(seed);
    Random random(seed);
    for (int trial = 0; trial < 100'000; ++trial) {
        const double size = trial % 2 == 0 ? 10 : 400;
        const auto a = operands.draw(-size, size);
        // Every third sum nearly cancels.
        auto b = trial % 3 == 0 ? -a : operands.draw(-size, size);
        if (trial % 3 == 0) b = exact_sum(b.hi * (1 + 0x1p-50 * random.below(4)), b.lo);
        const auto sum = a + b, product = a * b;
        ASSERT_TRUE(within_bound(sum, value_of(a) + value_of(b)));
        ASSERT_TRUE(within_bound(product, value_of(a) * value_of(b)));
        ASSERT_LE(sum.error, 0x1p-101 * (std::abs(a.hi) + std::abs(b.hi)));
        ASSERT_LE(product.error, 0x1p-101 * std::abs(product.hi) + 0x1p-1059);
        ASSERT_LE(std::abs(product.lo), 0x1p-53 * std::abs(product.hi));
    }
}

// What a and b stand for may be anywhere in their bounds, in their corners at the worst.
TEST(DoubleDouble, ErrorsAreInherited) {
    constexpr std::uint64_t seed = 71;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Operands operands(seed);
    Random random(seed);
    for (int trial = 0; trial < 20'000; ++trial) {
        auto a = operands.draw(-10, 10), b = operands.draw(-10, 10);
        a.error = std::abs(a.hi) * std::exp2(random.in(-80, 2));
        b.error = std::abs(b.hi) * std::exp2(random.in(-80, 2));
        for (const int s : {-1, 1}) {
            for (const int t : {-1, 1}) {
                const Exact x = value_of(a) + Exact(s * a.error);
                const Exact y = value_of(b) + Exact(t * b.error);
                ASSERT_TRUE(within_bound(a + b, x + y));
                ASSERT_TRUE(within_bound(a - b, x - y));
                ASSERT_TRUE(within_bound(a * b, x * y));
                ASSERT_TRUE(holds(enclosure(a), x));
                if (sign(a) != 0) {
                    ASSERT_EQ(sign(a) > 0, Exact(0) < x);
                }
            }
        }
    }
}

TEST(DoubleDouble, Underflow) {
    for (const double x : {1e-200, 1e-160, 0x1p-500, 0x1p-537, 0x1p-1022, smallest_positive}) {
        for (const double y : {1e-120, 1e-160, 0x1.1p-520, smallest_positive, 1.0}) {
            const auto a = exact_sum(x, x * 0x1p-54), b = exact_sum(y, -y * 0x1p-55);
            EXPECT_TRUE(within_bound(a * b, value_of(a) * value_of(b))) << x << ' ' << y;
            EXPECT_TRUE(within_bound(a + b, value_of(a) + value_of(b))) << x << ' ' << y;
        }
    }
}

TEST(DoubleDouble, EnclosuresAreTheDoublesBeside) {
    const auto third = exact_sum(1.0 / 3, 0x1p-54 / 3);
    EXPECT_LE(enclosure(third).hi, std::nextafter(1.0 / 3, 1));
    EXPECT_GE(enclosure(third).lo, std::nextafter(1.0 / 3, 0));
    EXPECT_EQ(enclosure({1e300, 0, infinity}), Interval::entire());
    EXPECT_EQ(enclosure(exactly(1e300) * exactly(1e300)), Interval::entire());
    EXPECT_EQ(sign({1e-30, 0, 1e-31}), 1);
    EXPECT_EQ(sign({-1e-30, 0, 1e-31}), -1);
    EXPECT_EQ(sign({1e-30, 0, 1e-30}), 0);
    EXPECT_EQ(sign({0, 0, 0}), 0);
}

TEST(DoubleDouble, TwoAtOnceAreTwoAlone) {
    constexpr std::uint64_t seed = 72;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Operands operands(seed);
    for (int trial = 0; trial < 1000; ++trial) {
        const auto a = operands.draw(-9, 9), b = operands.draw(-9, 9);
        const auto c = operands.draw(-9, 9), d = operands.draw(-9, 9);
        const auto both = [](const DoubleDouble<double>& x, const DoubleDouble<double>& y) {
            return DoubleDouble<Ends>{{x.hi, y.hi}, {x.lo, y.lo}, {x.error, y.error}};
        };
        const auto pair = both(a, b) * both(c, d) - twice(both(a, b));
        EXPECT_EQ(enclosure(one_of(pair, 0)), enclosure(a * c - twice(a)));
        EXPECT_EQ(enclosure(one_of(pair, 1)), enclosure(b * d - twice(b)));
    }
}

} // namespace
} // namespace isomotion::formula
