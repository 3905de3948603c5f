// Operations<Interval> against MPFR: enclosing, tight, and growing with their arguments.
#include "formula/interval/interval_operations.h"

#include <algorithm>
#include <random>
#include <vector>

#include "random_interval.h"
#include "thorough.h"

namespace isomotion::formula::interval_operations_test {
namespace {

using Do = Operations<Interval>;

struct Unary {
    Op op;
    Interval (*enclose)(Interval);
};
const std::vector<Unary> unary{{Op::negate, Do::negate},
#define ROW(name, ...) {Op::name, Do::name},
                               ISOMOTION_FUNCTIONS(ROW)
#undef ROW
};

struct Binary {
    Op op;
    Interval (*enclose)(Interval, Interval);
};
const std::vector<Binary> binary{
#define ROW(name, ...) {Op::name, Do::name},
    ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
};

// What Operations<double> cuts off.
bool is_cut_off(Op op) {
    switch (op) {
    case Op::exp:
    case Op::log:
    case Op::tan:
    case Op::sinh:
    case Op::cosh:
    case Op::divide:
    case Op::power:
        return true;
    default:
        return false;
    }
}

bool is_proper(Interval a) { return a.lo <= a.hi && a.lo < infinity && a.hi > -infinity; }

testing::AssertionResult encloses(Op op, Interval result, const Exact& value) {
    if (!is_proper(result)) return testing::AssertionFailure() << name(op) << " is improper";
    const bool turns = op == Op::angle; // the enclosure may hold the angle and a turn
    if (!holds(result, value) && !(turns && holds(result, value + Exact::pi() + Exact::pi())))
        return testing::AssertionFailure() << name(op) << " is " << value;
    if (is_cut_off(op) && !holds(result, saturated(value)))
        return testing::AssertionFailure() << name(op) << " is cut off at " << saturated(value);
    return testing::AssertionSuccess();
}

// Five members of each interval.
TEST(IntervalOperations, EncloseFunctionsOfOneArgument) {
    constexpr std::uint64_t seed = 60;
    IntervalGenerator random(seed);
    for (int trial = 0; trial < trials(35'000, 140'000); ++trial) {
        const Unary& f = unary[std::size_t(trial) % unary.size()];
        const Interval a = random.interval(), result = f.enclose(a);
        for (int k = 0; k < 5; ++k) {
            const Exact x = random.member(a);
            ASSERT_TRUE(encloses(f.op, result, apply(f.op, x)))
                << "seed " << seed << ": of " << testing::PrintToString(a) << " at " << x << ": "
                << testing::PrintToString(result);
        }
    }
}

// 500 000 pairs.
TEST(IntervalOperations, EncloseFunctionsOfTwoArguments) {
    constexpr std::uint64_t seed = 61;
    IntervalGenerator random(seed);
    for (int trial = 0; trial < trials(25'000, 100'000); ++trial) {
        const Binary& f = binary[std::size_t(trial) % binary.size()];
        Interval a = random.interval(), b = random.interval();
        if (f.op == Op::power) {
            b = random.exponent();
            if (random.below(2) == 0) a = Do::abs(a);
        }
        const Interval result = f.enclose(a, b);
        for (int k = 0; k < 5; ++k) {
            const Exact x = random.member(a), y = random.member(b);
            ASSERT_TRUE(encloses(f.op, result, apply(f.op, x, y)))
                << "seed " << seed << ": of " << testing::PrintToString(a) << " and "
                << testing::PrintToString(b) << " at " << x << " and " << y << ": "
                << testing::PrintToString(result);
        }
    }
}

TEST(IntervalOperations, EncloseSquaresAndChoices) {
    constexpr std::uint64_t seed = 62;
    IntervalGenerator random(seed);
    for (int trial = 0; trial < 20'000; ++trial) {
        const Interval a = random.interval(), b = random.interval();
        const Interval c = random.interval(), d = random.interval();
        const Interval chosen = Do::select(a, b, c, d);
        for (int k = 0; k < 3; ++k) {
            const Exact x = random.member(a), y = random.member(b);
            ASSERT_TRUE(encloses(Op::multiply, Do::square(a), x * x))
                << "seed " << seed << ": " << testing::PrintToString(a) << " at " << x;
            const Exact value = x < y ? random.member(c) : random.member(d);
            ASSERT_TRUE(encloses(Op::select, chosen, value)) << "seed " << seed;
        }
    }
}

// Products of nothing but overflow keep the bound of their sign only.
bool overflows(Interval a, Interval b) { return std::isinf(mignitude(a) * mignitude(b)); }

TEST(IntervalOperations, GrowWithTheirArguments) {
    constexpr std::uint64_t seed = 63;
    IntervalGenerator random(seed);
    for (int trial = 0; trial < trials(25'000, 100'000); ++trial) {
        const Interval a = random.interval(), b = random.interval();
        const Interval less_a = random.part(a), less_b = random.part(b);
        SCOPED_TRACE(testing::Message()
                     << "seed " << seed << ": " << testing::PrintToString(std::pair(a, less_a))
                     << ", " << testing::PrintToString(std::pair(b, less_b)));
        const Unary& f = unary[std::size_t(trial) % unary.size()];
        ASSERT_TRUE(contains(f.enclose(a), f.enclose(less_a))) << name(f.op);
        const Binary& g = binary[std::size_t(trial) % binary.size()];
        if (g.op == Op::angle) continue; // of a part may be a turn less
        if (g.op != Op::multiply || !overflows(less_a, less_b)) {
            ASSERT_TRUE(contains(g.enclose(a, b), g.enclose(less_a, less_b))) << name(g.op);
        }
        if (!overflows(less_a, less_a)) {
            ASSERT_TRUE(contains(Do::square(a), Do::square(less_a)));
        }
        if (magnitude(a) > 0) {
            ASSERT_TRUE(contains(Do::multiply(a, a), Do::square(a)));
        }
    }
}

// How many doubles lie between an end and the exact value, rounded.
double distance(double end, const Exact& value) {
    const double exact = value.rounded();
    if (end == exact) return 0;
    const double step = std::abs(std::nextafter(exact, end) - exact);
    return std::abs(end - exact) / step;
}

// The doubles by which the ends of an enclosure may be off, where both ends are values at ends.
double slack_of(Op op) {
    switch (op) {
    case Op::negate:
    case Op::abs:
    case Op::sign:
    case Op::floor:
    case Op::min:
    case Op::max:
        return 0;
    case Op::sqrt:
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
        return 3; // two steps from a double beside the exact value
    default:
        return 10; // 4 ulps, which are 8 doubles below a power of two
    }
}

TEST(IntervalOperations, AreTightWhereTheyRiseOrFall) {
    constexpr std::uint64_t seed = 64;
    Random random(seed);
    for (int trial = 0; trial < trials(15'000, 60'000); ++trial) {
        const Unary& f = unary[std::size_t(trial) % unary.size()];
        const double start = f.op == Op::log ? 1e-6 : f.op == Op::cos || f.op == Op::cosh ? 0 : -1;
        const double end = f.op == Op::cos   ? 3.1
                           : f.op == Op::tan ? 1.5
                           : f.op == Op::abs ? 0
                                             : 1.5;
        const double x = random.in(start, end), y = random.in(start, end);
        const Interval a{std::min(x, y), std::max(x, y)}, result = f.enclose(a);
        Exact low = apply(f.op, a.lo), high = apply(f.op, a.hi);
        if (high < low) std::swap(low, high);
        ASSERT_LE(distance(result.lo, low), slack_of(f.op))
            << "seed " << seed << ": " << name(f.op) << testing::PrintToString(a);
        ASSERT_LE(distance(result.hi, high), slack_of(f.op))
            << "seed " << seed << ": " << name(f.op) << testing::PrintToString(a);
    }
}

TEST(IntervalOperations, AreTightInTheirCorners) {
    constexpr std::uint64_t seed = 65;
    Random random(seed);
    for (int trial = 0; trial < 30'000; ++trial) {
        const Binary& f = binary[std::size_t(trial) % binary.size()];
        const auto draw = [&](double low) {
            const double x = random.in(low, 4), y = random.in(low, 4);
            return Interval(std::min(x, y), std::max(x, y));
        };
        const bool is_angle = f.op == Op::atan2 || f.op == Op::angle;
        const Interval a = draw(f.op == Op::power ? 0
                                : is_angle        ? 0.1
                                                  : -4),
                       b = draw(f.op == Op::divide ? 0.1 : -4);
        const Interval result = f.enclose(a, b);
        Exact low = apply(f.op, a.lo, b.lo), high = low;
        for (const auto& [x, y] : {std::pair(a.lo, b.hi), {a.hi, b.lo}, {a.hi, b.hi}}) {
            const Exact corner = apply(f.op, x, y);
            if (corner < low) low = corner;
            if (high < corner) high = corner;
        }
        ASSERT_LE(distance(result.lo, low), slack_of(f.op))
            << "seed " << seed << ": " << name(f.op) << testing::PrintToString(std::pair(a, b));
        ASSERT_LE(distance(result.hi, high), slack_of(f.op))
            << "seed " << seed << ": " << name(f.op) << testing::PrintToString(std::pair(a, b));
    }
}

// 0 and 1 of what a wave reaches inside: exactly 1 if a crest is inside, else the larger end.
TEST(IntervalOperations, WavesReachTheirCrestsAndNoFurther) {
    constexpr double pi = 3.14159265358979323846;
    EXPECT_EQ(Do::sin({0.5, 2}).hi, 1);
    EXPECT_LT(Do::sin({0.5, 1.57}).hi, 1);
    EXPECT_EQ(Do::sin({-2, 0.5}).lo, -1);
    EXPECT_EQ(Do::sin({0, pi}).lo, 0);
    EXPECT_EQ(Do::cos({-0.1, 0.1}).hi, 1);
    EXPECT_LT(Do::cos({0.1, 6.2}).hi, 1);
    EXPECT_EQ(Do::cos({0.1, 6.2}).lo, -1);
    EXPECT_EQ(Do::cos({-infinity, 7}), Interval(-1, 1));
    EXPECT_EQ(Do::sin({1e22, 1e22 * (1 + 0x1p-52)}), Interval(-1, 1));
    constexpr std::uint64_t seed = 66;
    Random random(seed);
    for (int trial = 0; trial < 20'000; ++trial) {
        const double x = random.in(-40, 40);
        const Interval a{x, x + random.in(0, 4)}, result = Do::sin(a);
        // The number of the half wave, crests at even ones.
        const auto half_wave = [&](double at) {
            return apply(Op::floor, Exact(at) / Exact::pi() - Exact(0.5)).rounded();
        };
        const double first = half_wave(a.lo) + 1, last = half_wave(a.hi);
        const bool crest = first < last || (first == last && std::fmod(first, 2) == 0);
        const bool trough = first < last || (first == last && std::fmod(first, 2) != 0);
        const Exact low = apply(Op::sin, a.lo), high = apply(Op::sin, a.hi);
        const double top = crest ? 1 : (low < high ? high : low).rounded();
        const double bottom = trough ? -1 : (low < high ? low : high).rounded();
        ASSERT_NEAR(result.hi, top, 0x1p-49 * std::abs(top)) << "seed " << seed << ' ' << x;
        ASSERT_NEAR(result.lo, bottom, 0x1p-49 * std::abs(bottom)) << "seed " << seed << ' ' << x;
    }
}

// Between doubles so far out that a crest of sin is somewhere between neighbours, if at all: a wave
// is as high as it is there, whatever rounding makes of the number of half turns.
TEST(IntervalOperations, WavesReachTheirCrestsFarOut) {
    constexpr std::uint64_t seed = 67;
    Random random(seed);
    for (int trial = 0; trial < 20'000; ++trial) {
        const double crest = std::floor(std::exp2(random.in(2, 48))) + 0.5;
        const Exact place = Exact(crest) * Exact::pi();
        const double x = place.rounded();
        const Interval a = place < Exact(x) ? Interval(std::nextafter(x, 0), x)
                                            : Interval(x, std::nextafter(x, infinity));
        const Interval result = Do::sin(a);
        const double top = std::fmod(crest, 2) == 0.5 ? 1 : -1;
        ASSERT_TRUE(contains(result, top)) << "seed " << seed << ": about " << x;
    }
}

// Also where the argument is reduced to the ends of its range, at odd multiples of ln(2)/2.
TEST(IntervalOperations, ExponentialIsWithinItsBound) {
    constexpr std::uint64_t seed = 66;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(-708, 709), small(-1, 1);
    for (int trial = 0; trial < trials(50'000, 200'000); ++trial) {
        double x = any(random);
        if (trial % 4 == 1) x = (std::floor(x) + 0.5) * 0.69314718055994531 + 1e-13 * small(random);
        if (trial % 4 == 2) x = small(random);
        if (trial % 4 == 3) x = std::ldexp(small(random), -trial % 60);
        x = std::clamp(x, -708.0, 709.0);
        const Exact truth = apply(Op::exp, x), value = exponential(x);
        const Exact error = (value - truth) / truth;
        ASSERT_LE(std::abs(error.rounded()), 0x1p-51) << "seed " << seed << ": " << x;
    }
    for (const double x : {0.0, -0.0, 709.0, -708.0, 0x1p-1074}) {
        const Exact error = Exact(exponential(x)) / apply(Op::exp, x) - Exact(1.0);
        EXPECT_LE(std::abs(error.rounded()), 0x1p-51) << x;
    }
}

TEST(IntervalOperations, EndOfDomains) {
    const Interval all = Interval::entire();
    EXPECT_EQ(Do::log({-1, 2}), all);
    EXPECT_EQ(Do::log({0, 1}), Interval(-infinity, 0));
    EXPECT_EQ(Do::sqrt({-4, -1}), Interval(0.0));
    EXPECT_EQ(Do::sqrt({-4, 0}), Interval(0.0));
    EXPECT_EQ(Do::acos({1, 3}), Interval(0.0));
    EXPECT_EQ(Do::tan({1, 2}), all);
    EXPECT_LT(Do::tan({-1.5, 1.5}).hi, 15);
    EXPECT_EQ(Do::exp(all), Interval(0, infinity));
    EXPECT_EQ(Do::exp({1e4, 1e5}), Interval(Do::saturation(), infinity));
    EXPECT_EQ(Do::cosh({-1e4, 1}).lo, 1);
    EXPECT_EQ(Do::tanh(all), Interval(-1, 1));
    EXPECT_EQ(Do::erf(all), Interval(-1, 1));
    EXPECT_EQ(Do::erf({0, 1}).lo, 0);
    EXPECT_EQ(Do::acosh({-3, 1}), Interval(0.0));
    EXPECT_EQ(Do::acosh(all), Interval(0, infinity));
    EXPECT_EQ(Do::asinh(all), all);
    EXPECT_EQ(Do::cbrt(all), all);
    EXPECT_EQ(Do::cbrt({0, infinity}), Interval(0, infinity));
}

TEST(IntervalOperations, Powers) {
    const Interval all = Interval::entire();
    EXPECT_EQ(Do::power({-3, 2}, 0.0), Interval(1.0));
    EXPECT_EQ(Do::power({-3, 2}, 0.5), all);
    EXPECT_EQ(Do::power({-3, 2}, {2, 3}), all);
    EXPECT_EQ(Do::power({-3, 2}, -1.0), all);
    EXPECT_EQ(Do::power({-3, 0}, -1.0), all); // 0^-1 is +10^300
    EXPECT_EQ(Do::power({-3, 2}, 2.0).lo, 0);
    EXPECT_NEAR(Do::power({-3, 2}, 2.0).hi, 9, 1e-13);
    EXPECT_NEAR(Do::power({-3, 2}, 3.0).lo, -27, 1e-13);
    EXPECT_NEAR(Do::power({-3, 2}, 3.0).hi, 8, 1e-13);
    EXPECT_NEAR(Do::power({-3, -2}, -3.0).lo, -1.0 / 8, 1e-15);
    EXPECT_NEAR(Do::power({-3, -2}, -3.0).hi, -1.0 / 27, 1e-15);
    EXPECT_EQ(Do::power({0, 2}, {-1, 0.5}), Interval(0, infinity));
    EXPECT_NEAR(Do::power({0, 2}, {0.5, 3}).hi, 8, 1e-13);
    EXPECT_EQ(Do::power({0, 2}, {0.5, 3}).lo, 0);
    EXPECT_EQ(Do::power({0, 0.5}, -1.0).hi, infinity);
    EXPECT_NEAR(Do::power({0, 0.5}, -1.0).lo, 2, 1e-14);
    EXPECT_EQ(Do::power(0.0, -1.0), Interval(Do::saturation(), infinity));
}

// A box about the origin of the plane, about the cut, and on each side of it.
TEST(IntervalOperations, AnglesGoOnAcrossTheCut) {
    constexpr double pi = 3.14159265358979323846;
    const auto is_near = [](Interval a, double lo, double hi) {
        return std::abs(a.lo - lo) < 1e-14 && std::abs(a.hi - hi) < 1e-14;
    };
    EXPECT_TRUE(is_near(Do::angle({-1, 1}, {-2, -1}), 0.75 * pi, 1.25 * pi));
    EXPECT_TRUE(is_near(Do::atan2({-1, 1}, {-2, -1}), -pi, pi));
    EXPECT_TRUE(is_near(Do::angle({-1, 1}, {-2, 1}), -pi, pi));
    EXPECT_TRUE(is_near(Do::atan2({-1, 1}, {1, 2}), -0.25 * pi, 0.25 * pi));
    EXPECT_TRUE(is_near(Do::atan2({0, 1}, {-2, -1}), 0.75 * pi, pi));
    EXPECT_TRUE(is_near(Do::atan2({0, 1}, {-2, 3}), 0, pi));
    EXPECT_TRUE(is_near(Do::atan2({-1, -0.5}, {-1, 1}), -pi + std::atan(0.5), -std::atan(0.5)));
    EXPECT_TRUE(is_near(Do::atan2({1, 2}, {-1, 1}), 0.25 * pi, 0.75 * pi));
    // Points that no double tells from the cut are on both sides of it.
    EXPECT_TRUE(is_near(Do::atan2({-smallest_positive, 0}, -1.0), -pi, pi));
    EXPECT_TRUE(holds(Do::atan2(0.0, -1.0), Exact::pi()));
    EXPECT_TRUE(contains(Do::atan2(0.0, 0.0), 0.0));
}

TEST(IntervalOperations, ChoicesUndecidedTakeBoth) {
    EXPECT_EQ(Do::select({0, 1}, {2, 3}, 5.0, 7.0), Interval(5.0));
    EXPECT_EQ(Do::select({2, 3}, {0, 2}, 5.0, 7.0), Interval(7.0)); // 2 < 2 is false
    EXPECT_EQ(Do::select({0, 2}, {2, 3}, 5.0, 7.0), Interval(5, 7));
}

} // namespace
} // namespace isomotion::formula::interval_operations_test
