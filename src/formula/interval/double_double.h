// Double-double numbers with a bound on their own error.
//
// A DoubleDouble is the unevaluated sum of two doubles, |lo| at most half an ulp of hi. It
// represents a real number that differs from that sum by at most `error`. Sums and products use the
// usual error-free transformations (Dekker 1971, Knuth). Joldes, Muller and Popescu, Tight and
// Rigorous Error Bounds for Basic Building Blocks of Double-Word Arithmetic, ACM TOMS 44(2), 2017,
// bound their rounding errors by a few 2^-106 of the operands; 2^-102 is counted here. Underflow
// costs a few smallest_positive; 2^-1060 is counted. Values beyond 10^290 overflow to a
// DoubleDouble that is not finite: see enclosure().
//
// V is double, or Ends to compute with two numbers at once.
#pragma once

#include "formula/interval/interval.h"

namespace isomotion::formula {

using Ends = double __attribute__((vector_size(16))); // two doubles in one register

template<class V> struct DoubleDouble { V hi{}, lo{}, error{}; };

template<class V> DoubleDouble<V> exactly(V value) { return {value, V{}, V{}}; }

template<class V> V absolute(V a) {
    return a < 0 ? -a : a; // one operation, of Ends too
}

// hi + lo = a + b exactly.
template<class V> DoubleDouble<V> exact_sum(V a, V b, V error = V{}) {
    const V s = a + b, b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part), error};
}

// hi + lo = a * b exactly, short of underflow.
template<class V> DoubleDouble<V> exact_product(V a, V b) {
    constexpr double splitter = 0x1p27 + 1; // into halves of 26 bits
    const V a_shifted = splitter * a, b_shifted = splitter * b;
    const V a_hi = a_shifted - (a_shifted - a), b_hi = b_shifted - (b_shifted - b);
    const V a_lo = a - a_hi, b_lo = b - b_hi;
    const V p = a * b;
    return {p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo, V{}};
}

// Covers the rounding of computing a bound, and the use of hi as the size of hi + lo in it.
inline constexpr double bound_slack = 1 + 0x1p-40;

template<class V> DoubleDouble<V> operator-(DoubleDouble<V> a) { return {-a.hi, -a.lo, a.error}; }

template<class V> DoubleDouble<V> operator+(DoubleDouble<V> a, DoubleDouble<V> b) {
    const DoubleDouble<V> s = exact_sum(a.hi, b.hi);
    const V rounding = (absolute(a.hi) + absolute(b.hi)) * 0x1p-102;
    return exact_sum(s.hi, s.lo + (a.lo + b.lo), (a.error + b.error + rounding) * bound_slack);
}

template<class V> DoubleDouble<V> operator-(DoubleDouble<V> a, DoubleDouble<V> b) { return a + -b; }

template<class V> DoubleDouble<V> operator*(DoubleDouble<V> a, DoubleDouble<V> b) {
    const DoubleDouble<V> p = exact_product(a.hi, b.hi);
    const V inherited = absolute(a.hi) * b.error + absolute(b.hi) * a.error + a.error * b.error;
    const V rounding = absolute(p.hi) * 0x1p-102 + 0x1p-1060;
    return exact_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi),
                     (inherited + rounding) * bound_slack);
}

template<class V> DoubleDouble<V> twice(DoubleDouble<V> a) {
    return {2 * a.hi, 2 * a.lo, 2 * a.error};
}

// 1 or -1 if the sign is certain, otherwise 0.
inline int sign(DoubleDouble<double> a) {
    if (std::abs(a.hi) * (1 - 0x1p-50) > a.error) return a.hi > 0 ? 1 : -1;
    return 0;
}

// The real numbers that it may represent: all, if it has overflowed.
inline Interval enclosure(DoubleDouble<double> a) {
    if (!std::isfinite(a.hi) || !std::isfinite(a.lo) || !std::isfinite(a.error))
        return Interval::entire();
    return {round_down(a.hi + round_down(a.lo - a.error)),
            round_up(a.hi + round_up(a.lo + a.error))};
}

inline DoubleDouble<double> one_of(const DoubleDouble<Ends>& a, int which) {
    return {a.hi[which], a.lo[which], a.error[which]};
}

} // namespace isomotion::formula
