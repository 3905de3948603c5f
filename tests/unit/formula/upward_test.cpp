// What Evaluator<Interval> makes of one operation, against MPFR: each end is rounded outwards by as
// little as there is.
#include "formula/interval/upward.h"

#include <functional>

#include "formula/interval/rounding_upwards.h"
#include "random_interval.h"

namespace isomotion::formula::upward_test {
namespace {

using Do = Operations<Interval>;

// Of x and y, for a block of points and each point alone.
class OfTwo {
public:
    explicit OfTwo(std::string_view text)
        : evaluator_([&] {
            Graph graph;
            const NodeId root = parse(graph, text);
            return schedule(graph, std::array{root});
        }()) {}

    std::vector<Interval> operator()(const std::vector<Interval>& x, const std::vector<Interval>& y,
                                     Interval parameter = 0) {
        Bindings<Interval> bindings;
        bindings.parameters = {parameter};
        const std::array<std::span<const Interval>, 3> inputs{x, y, y};
        std::vector<Interval> values(x.size());
        std::array<std::span<Interval>, 1> outputs{values};
        evaluator_.points(bindings, inputs, outputs);
        for (std::size_t k = 0; k < x.size(); ++k) {
            Interval alone;
            evaluator_.point(bindings, std::array{x[k], y[k], y[k]}, {&alone, 1});
            EXPECT_EQ(alone, values[k]);
        }
        return values;
    }

private:
    Evaluator<Interval> evaluator_;
};

// Both rounded outwards, first to 200 bits: what is rounded down twice is rounded down.
using Rule = int(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
double rounded(Rule* rule, double a, double b, mpfr_rnd_t way) {
    Exact result;
    rule(result.get(), Exact(a).get(), Exact(b).get(), way);
    return mpfr_get_d(result.get(), way);
}
Interval of_numbers(Rule* rule, double a, double b) {
    return {rounded(rule, a, b, MPFR_RNDD), rounded(rule, a, b, MPFR_RNDU)};
}
// Of a rule that is extreme at the ends of both.
Interval of_ends(Rule* rule, Interval a, Interval b) {
    const auto at = [&](double x, double y) {
        if (rule == mpfr_mul && (x == 0 || y == 0)) return Interval(0.0); // also times infinity
        return of_numbers(rule, x, y);
    };
    return hull(hull(at(a.lo, b.lo), at(a.lo, b.hi)), hull(at(a.hi, b.lo), at(a.hi, b.hi)));
}

Interval sum(Interval a, Interval b) {
    return {rounded(mpfr_add, a.lo, b.lo, MPFR_RNDD), rounded(mpfr_add, a.hi, b.hi, MPFR_RNDU)};
}
Interval product(Interval a, Interval b) { return of_ends(mpfr_mul, a, b); }
Interval square_of(Interval a) {
    const double least = mignitude(a), most = magnitude(a);
    return {rounded(mpfr_mul, least, least, MPFR_RNDD), rounded(mpfr_mul, most, most, MPFR_RNDU)};
}
// Of a divisor that isn't 0.
Interval quotient(Interval a, Interval b) {
    const bool is_negative = b.hi < 0;
    const Interval n = is_negative ? -a : a, d = is_negative ? -b : b;
    return Do::saturate({rounded(mpfr_div, n.lo, n.lo < 0 ? d.lo : d.hi, MPFR_RNDD),
                         rounded(mpfr_div, n.hi, n.hi < 0 ? d.hi : d.lo, MPFR_RNDU)});
}
Interval magnitudes(Interval a) { return {mignitude(a), magnitude(a)}; }

// Built by other compilers the evaluator computes with wider ends (rounding_upwards.h).
#if defined(__GNUC__) && !defined(__clang__)
constexpr bool ends_are_nearest = true;
#else
constexpr bool ends_are_nearest = false;
#endif
bool is_expected(Interval found, Interval tightest) {
    return ends_are_nearest ? found == tightest : contains(found, tightest);
}

struct Operation {
    const char* text;
    std::function<Interval(Interval, Interval)> tightest;
};

TEST(Upward, EndsAreTheNearestDoublesOutside) {
    constexpr std::uint64_t seed = 71;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator random(seed);
    std::vector<Interval> x, y;
    for (int k = 0; k < 6'000; ++k) {
        x.push_back(random.interval());
        y.push_back(random.interval());
    }
    const std::vector<Operation> operations{
        {"x + y", sum},
        {"x - y", [](Interval a, Interval b) { return sum(a, -b); }},
        {"x*y", product},
        {"x*abs(y)", [](Interval a, Interval b) { return product(a, magnitudes(b)); }},
        {"abs(x)*abs(y)",
         [](Interval a, Interval b) { return product(magnitudes(a), magnitudes(b)); }},
        {"x*0.3", [](Interval a, Interval) { return product(a, 0.3); }},
        {"x*(-0.3)", [](Interval a, Interval) { return product(a, -0.3); }},
        {"x*x", [](Interval a, Interval) { return square_of(a); }},
        {"max(x, y)", [](Interval a, Interval b) { return Do::max(a, b); }},
        {"min(x, y)", [](Interval a, Interval b) { return Do::min(a, b); }},
    };
    for (const auto& [text, tightest] : operations) {
        SCOPED_TRACE(text);
        const std::vector<Interval> values = OfTwo(text)(x, y);
        for (std::size_t k = 0; k < x.size(); ++k)
            ASSERT_PRED2(is_expected, values[k], tightest(x[k], y[k]))
                << testing::PrintToString(std::pair(x[k], y[k]));
    }
}

TEST(Upward, FactorsThatAreTheSameAtAllPoints) {
    constexpr std::uint64_t seed = 72;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator random(seed);
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<Interval> x;
        for (int k = 0; k < 32; ++k) x.push_back(random.interval());
        const Interval factor = random.interval();
        SCOPED_TRACE(testing::PrintToString(factor));
        const std::vector<Interval> values = OfTwo("x*a")(x, x, factor);
        for (std::size_t k = 0; k < x.size(); ++k)
            ASSERT_PRED2(is_expected, values[k], product(x[k], factor))
                << testing::PrintToString(x[k]);
    }
}

TEST(Upward, QuotientsAreTightAndNoWiderThanAnInterval) {
    constexpr std::uint64_t seed = 73;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator random(seed);
    std::vector<Interval> x, y;
    for (int k = 0; k < 20'000; ++k) {
        x.push_back(random.interval());
        y.push_back(random.interval());
    }
    const std::vector<Interval> values = OfTwo("x/y")(x, y);
    int signs = 0, zeros = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        SCOPED_TRACE(testing::PrintToString(std::pair(x[k], y[k])));
        ASSERT_TRUE(contains(Do::divide(x[k], y[k]), values[k]));
        if (!contains(y[k], 0.0)) {
            ++signs;
            ASSERT_PRED2(is_expected, values[k], quotient(x[k], y[k]));
            continue;
        }
        ++zeros;
        for (int trial = 0; trial < 3; ++trial) {
            const Exact value = apply(Op::divide, random.member(x[k]), random.member(y[k]));
            ASSERT_TRUE(holds(values[k], value) &&
                        (value.is_undefined() || holds(values[k], saturated(value))))
                << value;
        }
    }
    EXPECT_GT(signs, 3'000);
    EXPECT_GT(zeros, 3'000);
}

// Their error bounds ask for the nearest double.
TEST(Upward, FunctionsAreThoseOfIntervals) {
    constexpr std::uint64_t seed = 74;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    IntervalGenerator random(seed);
    std::vector<Interval> x;
    for (int k = 0; k < 2'000; ++k) x.push_back(random.interval());
#define ROW(name, ...)                                                                             \
    {                                                                                              \
        SCOPED_TRACE(#name);                                                                       \
        const std::vector<Interval> values = OfTwo(#name "(x)")(x, x);                             \
        for (std::size_t k = 0; k < x.size(); ++k)                                                 \
            ASSERT_EQ(values[k], Do::name(x[k])) << testing::PrintToString(x[k]);                  \
    }
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW
}

TEST(Upward, TheProcessorRoundsAsBefore) {
    ASSERT_TRUE(can_round_upwards());
    volatile double one = 1, little = 0x1p-60;
    OfTwo of_two("exp(x)*y + sin(x)/y");
    of_two({Interval(1, 2)}, {Interval(1, 3)});
    EXPECT_EQ(one + little, 1);
    {
        RoundingUpwards upwards;
        EXPECT_GT(one + little, 1);
        upwards.pause();
        EXPECT_EQ(one + little, 1);
        upwards.resume();
        EXPECT_GT(one + little, 1);
    }
    EXPECT_EQ(one + little, 1);
}

} // namespace
} // namespace isomotion::formula::upward_test
