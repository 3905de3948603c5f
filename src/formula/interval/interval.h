// Closed intervals of real numbers, rounded outwards.
//
// An Interval represents the real numbers x with lo <= x <= hi. An infinite end means that there is
// no bound on that side. Infinity is not a member, so 0 times an unbounded interval is 0. An
// interval is never empty (lo <= hi, lo < inf, hi > -inf) and its ends are never NaN. The exception
// is intersect(), which may return one with lo > hi: check is_empty() before using it.
//
// An operation returns an interval that contains its value for all members of the arguments. An
// operation that has no value somewhere (0/0) returns the entire line. The code needs doubles that
// round to nearest and keep subnormal numbers. upward.h computes the same while the processor
// rounds upwards.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

namespace isomotion::formula {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the bounds below hold for IEEE doubles without extra precision");

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest_finite = std::numeric_limits<double>::max();
inline constexpr double smallest_positive = std::numeric_limits<double>::denorm_min();

// Return the second argument if either is NaN, as the processor's minimum and maximum do.
constexpr double smaller(double a, double b) { return a < b ? a : b; }
constexpr double larger(double a, double b) { return b < a ? a : b; }

struct Interval {
    double lo = 0, hi = 0;

    constexpr Interval() = default;
    constexpr Interval(double low, double high)
        : lo(low)
        , hi(high) {}
    // The point. For an infinite argument, everything beyond the largest double; for NaN, the
    // entire line. Implicit, since every number is an interval.
    constexpr Interval(double point)
        : lo(point != point ? -infinity : smaller(point, largest_finite))
        , hi(point != point ? infinity : larger(point, -largest_finite)) {}

    static constexpr Interval entire() { return {-infinity, infinity}; }

    bool operator==(const Interval&) const = default;
};

constexpr bool is_empty(Interval a) { return !(a.lo <= a.hi); }
constexpr bool is_point(Interval a) { return a.lo == a.hi; }
constexpr bool contains(Interval a, double x) { return a.lo <= x && x <= a.hi; }
constexpr bool contains(Interval a, Interval b) { return a.lo <= b.lo && b.hi <= a.hi; }

constexpr Interval hull(Interval a, Interval b) {
    return {smaller(a.lo, b.lo), larger(a.hi, b.hi)};
}
constexpr Interval intersect(Interval a, Interval b) {
    return {larger(a.lo, b.lo), smaller(a.hi, b.hi)};
}

// The largest and the smallest distance of a member from 0.
constexpr double magnitude(Interval a) { return larger(-a.lo, a.hi); }
constexpr double mignitude(Interval a) { return larger(larger(a.lo, -a.hi), 0.0); }

// A finite member in the middle, also for unbounded intervals.
constexpr double mid(Interval a) {
    const double middle = larger(a.lo, -largest_finite) / 2 + smaller(a.hi, largest_finite) / 2;
    return smaller(larger(middle, a.lo), a.hi); // halves of subnormal ends are rounded
}

// Rounding outwards. r is the double nearest to the exact value of one operation, which therefore
// lies no further out than the double next to r. Let 2^e <= |r| < 2^(e+1), so that doubles next to
// r are at most 2h apart, h = 2^(e-53). 3/2 h is more than h also where it is rounded among the
// subnormals, so r -+ 3/2 2^-53 |r| is beyond the midpoint of r and its neighbour and rounds to the
// neighbour or to the one after it. That needs h to be a double. It isn't where |r| < 2^-1021, but
// there sums and square roots are exact; products and quotients are not, and take one
// smallest_positive more as `underflow`. A lower end that overflows becomes finite: what is
// rounded to infinity is larger than largest_finite.
inline double rounding(double r) { return std::abs(r) * 0x1.8p-53; }
inline double round_down(double r, double underflow = 0) {
    r = smaller(r, largest_finite);
    return r - (rounding(r) + underflow);
}
inline double round_up(double r, double underflow = 0) {
    r = larger(r, -largest_finite);
    return r + (rounding(r) + underflow);
}

// At least hi - lo; infinite for unbounded intervals.
inline double width(Interval a) { return is_point(a) ? 0 : round_up(a.hi - a.lo); }

// The arithmetic below has no branches, and each condition is one comparison, so that loops over it
// vectorise.

inline Interval operator-(Interval a) { return {-a.hi, -a.lo}; }

inline Interval operator+(Interval a, Interval b) {
    return {round_down(a.lo + b.lo), round_up(a.hi + b.hi)};
}

inline Interval operator-(Interval a, Interval b) { return a + -b; }

inline Interval operator*(Interval a, Interval b) {
    // 0 times an infinite end is NaN here, but 0 by definition. smaller() and larger() drop the
    // NaN, and a product of two finite members replaces it.
    const double member = larger(a.lo, -largest_finite) * larger(b.lo, -largest_finite);
    const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    const double lo = smaller(s, smaller(r, smaller(q, smaller(p, member))));
    const double hi = larger(s, larger(r, larger(q, larger(p, member))));
    // Underflow must not move a product across 0, since a result that isn't negative may be a
    // divisor or a radicand. So the result is at least 0 if both factors are positive or both
    // negative, and at most 0 if they differ.
    const double both_positive = smaller(a.lo, b.lo) >= 0 ? 0.0 : -infinity;
    const double floor = larger(a.hi, b.hi) <= 0 ? 0.0 : both_positive;
    const double negative_b = larger(-a.lo, b.hi) <= 0 ? 0.0 : infinity;
    const double ceiling = larger(a.hi, -b.lo) <= 0 ? 0.0 : negative_b;
    // A bound that overflows inwards becomes infinity - infinity; the comparison replaces it by the
    // limit.
    return {larger(lo - (rounding(lo) + smallest_positive), floor),
            smaller(hi + (rounding(hi) + smallest_positive), ceiling)};
}

// The same products with fewer comparisons, where signs are known. Where b is just 0, an end that
// is 0 above may be smallest_positive beyond it here.
//
// b has no member below 0. A product of 0 and an infinite end is NaN, and drops out.
inline Interval times_not_negative(Interval a, Interval b) {
    const double lo = smaller(a.lo * b.hi, larger(a.lo, -largest_finite) * b.lo);
    const double hi = larger(a.hi * b.hi, smaller(a.hi, largest_finite) * b.lo);
    return {larger(lo - (rounding(lo) + smallest_positive), a.lo >= 0 ? 0.0 : -infinity),
            smaller(hi + (rounding(hi) + smallest_positive), a.hi <= 0 ? 0.0 : infinity)};
}
// Nor has a.
inline Interval product_not_negative(Interval a, Interval b) {
    const double lo = a.lo * b.lo, hi = larger(a.hi * b.hi, lo);
    return {larger(lo - (rounding(lo) + smallest_positive), 0.0),
            hi + (rounding(hi) + smallest_positive)};
}
// b is a finite number above 0.
inline Interval times_positive(Interval a, double b) {
    const double lo = a.lo * b, hi = a.hi * b;
    return {larger(lo - (rounding(lo) + smallest_positive), a.lo >= 0 ? 0.0 : -infinity),
            smaller(hi + (rounding(hi) + smallest_positive), a.hi <= 0 ? 0.0 : infinity)};
}

// a * a for one a. a * b for two equal intervals is wider.
inline Interval square(Interval a) {
    const double lo = mignitude(a) * mignitude(a), hi = magnitude(a) * magnitude(a);
    return {larger(lo - (rounding(lo) + smallest_positive), 0.0), // as above
            hi + (rounding(hi) + smallest_positive)};
}

// Divisors with a lower end of 0 give the widest quotient of their positive members, and 0 itself
// gives what positive divisors near it give. Other divisors that hold 0, and 0/0, give the entire
// line.
inline Interval operator/(Interval a, Interval b) {
    const bool negative = b.hi < 0;
    const double n_lo = negative ? -a.hi : a.lo, n_hi = negative ? -a.lo : a.hi;
    const double d_lo = (negative ? -b.hi : b.lo) + 0.0; // + 0.0: no negative zero
    const double d_hi = (negative ? -b.lo : b.hi) + 0.0;
    const double lo = round_down(n_lo / (n_lo < 0 ? d_lo : d_hi), smallest_positive);
    const double hi = round_up(n_hi / (n_hi < 0 ? d_hi : d_lo), smallest_positive);
    // Positive if there is a bound: the divisor is positive, or it ends at 0 and the numerator
    // doesn't hold 0.
    const double bounded = d_lo == 0 ? larger(n_lo, -n_hi) : d_lo;
    return {bounded > 0 ? larger(n_lo >= 0 ? 0.0 : -infinity, lo) : -infinity,
            bounded > 0 ? smaller(n_hi <= 0 ? 0.0 : infinity, hi) : infinity};
}

} // namespace isomotion::formula
