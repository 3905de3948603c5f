// Numbers of twice the precision of double, with a bound on their own error.
//
// A Twofold is the unevaluated sum of two doubles, |lo| at most half an ulp of hi, and stands for
// some real number no further from that sum than `error`. Sums and products go by the usual
// error-free transformations (Dekker 1971, Knuth); Joldes, Muller and Popescu, Tight and Rigorous
// Error Bounds for Basic Building Blocks of Double-Word Arithmetic, ACM TOMS 44(2), 2017, bounds
// their roundings by a few 2^-106 of the operands, where 2^-102 is counted here. Underflow costs a
// few smallest_positive, where 2^-1060 is counted. Values past 10^290 overflow to a Twofold that is
// not finite: see enclosure().
#pragma once

#include "formula/interval.h"

namespace isomotion::formula {

struct Twofold {
    double hi = 0, lo = 0, error = 0;

    constexpr Twofold() = default;
    constexpr Twofold(double value)
        : hi(value) {}
    constexpr Twofold(double high, double low, double bound)
        : hi(high)
        , lo(low)
        , error(bound) {}
};

// hi + lo = a + b exactly.
inline Twofold exact_sum(double a, double b, double error = 0) {
    const double s = a + b, b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part), error};
}

// hi + lo = a * b exactly, short of underflow.
inline Twofold exact_product(double a, double b) {
    constexpr double splitter = 0x1p27 + 1; // into halves of 26 bits
    const double a_shifted = splitter * a, b_shifted = splitter * b;
    const double a_hi = a_shifted - (a_shifted - a), b_hi = b_shifted - (b_shifted - b);
    const double a_lo = a - a_hi, b_lo = b - b_hi;
    const double p = a * b;
    return {p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo, 0};
}

// The roundings of computing a bound, and hi for hi + lo in it.
inline constexpr double bound_slack = 1 + 0x1p-40;

inline Twofold operator-(Twofold a) { return {-a.hi, -a.lo, a.error}; }

inline Twofold operator+(Twofold a, Twofold b) {
    const Twofold s = exact_sum(a.hi, b.hi);
    const double rounding = (std::abs(a.hi) + std::abs(b.hi)) * 0x1p-102;
    return exact_sum(s.hi, s.lo + (a.lo + b.lo), (a.error + b.error + rounding) * bound_slack);
}

inline Twofold operator-(Twofold a, Twofold b) { return a + -b; }

inline Twofold operator*(Twofold a, Twofold b) {
    const Twofold p = exact_product(a.hi, b.hi);
    const double inherited =
        std::abs(a.hi) * b.error + std::abs(b.hi) * a.error + a.error * b.error;
    const double rounding = std::abs(p.hi) * 0x1p-102 + 0x1p-1060;
    return exact_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi),
                     (inherited + rounding) * bound_slack);
}

// a * 2^n, n small.
inline Twofold scaled(Twofold a, double power_of_two) {
    return {a.hi * power_of_two, a.lo * power_of_two, a.error * power_of_two};
}

// 1 or -1 if that is certain, else 0.
inline int sign(Twofold a) {
    if (std::abs(a.hi) * (1 - 0x1p-50) > a.error) return a.hi > 0 ? 1 : -1;
    return 0;
}

// The numbers it may stand for: all, if it has overflowed.
inline Interval enclosure(Twofold a) {
    if (!std::isfinite(a.hi) || !std::isfinite(a.lo) || !std::isfinite(a.error))
        return Interval::entire();
    return {round_down(a.hi + round_down(a.lo - a.error)),
            round_up(a.hi + round_up(a.lo + a.error))};
}

} // namespace isomotion::formula
