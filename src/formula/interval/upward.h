// Intervals for a processor that rounds upwards: the lower end is kept as its negative, so that
// each end of a result is one operation, rounded outwards by as little as there is.
//
// The rules are those of interval.h and interval_operations.h. Only sources that are compiled for
// any rounding mode (-frounding-math) may hold these operations, and only while RoundingUpwards
// lasts: other compilers take -(a b) for (-a) b. Functions are those of Interval, whose error
// bounds hold while the processor rounds to nearest.
#pragma once

#include "formula/graph/function_table.h"
#include "formula/interval/interval.h"
#include "formula/interval/interval_operations.h"

namespace isomotion::formula {

struct Upward {
    double low = 0, hi = 0; // low is the lower end's negative

    constexpr Upward() = default;
    constexpr Upward(double negative_lo, double high)
        : low(negative_lo)
        , hi(high) {}
    constexpr Upward(Interval a)
        : low(-a.lo)
        , hi(a.hi) {}
    constexpr Upward(double point)
        : Upward(Interval(point)) {}
    constexpr operator Interval() const { return {0.0 - low, hi}; } // no negative zero

    bool operator==(const Upward&) const = default;
};

inline Upward operator-(Upward a) { return {a.hi, a.low}; }

// As those of the same names for Interval.
//
// What is smallest in magnitude is 0 or rounds to it, so no product of factors of known signs
// crosses 0.
inline Upward times_not_negative(Upward a, Upward b) {
    const double least = -b.low;
    return {larger(a.low * b.hi, smaller(a.low, largest_finite) * least),
            larger(a.hi * b.hi, smaller(a.hi, largest_finite) * least)};
}
inline Upward product_not_negative(Upward a, Upward b) {
    return {a.low * -b.low, larger(a.hi * b.hi, 0.0)};
}
inline Upward times_positive(Upward a, double b) { return {a.low * b, a.hi * b}; }

struct FunctionsOfUpward {
#define ROW(name, ...)                                                                             \
    static Upward name(Upward a) { return Operations<Interval>::name(a); }
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW
#define ROW(name, ...)                                                                             \
    static Upward name(Upward a, Upward b) { return Operations<Interval>::name(a, b); }
    ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
};

template<> struct Operations<Upward> : FunctionsOfUpward {
    using Plain = Operations<Interval>;

    static Upward negate(Upward a) { return -a; }
    static Upward abs(Upward a) {
        return {smaller(smaller(a.low, a.hi), 0.0), larger(a.low, a.hi)};
    }
    static Upward add(Upward a, Upward b) { return {a.low + b.low, a.hi + b.hi}; }
    static Upward subtract(Upward a, Upward b) { return {a.low + b.hi, a.hi + b.low}; }
    static Upward multiply(Upward a, Upward b) {
        const double a_lo = -a.low, less_a_hi = -a.hi;
        // A product of two finite members stands in for 0 times an infinite end, which is NaN.
        const double x = smaller(a.low, largest_finite), y = smaller(b.low, largest_finite);
        const double low =
            larger(a.hi * b.low,
                   larger(a.low * b.hi, larger(less_a_hi * b.hi, larger(a_lo * b.low, -x * y))));
        const double hi =
            larger(less_a_hi * b.low,
                   larger(a_lo * b.hi, larger(a.hi * b.hi, larger(a.low * b.low, x * y))));
        return {low, hi};
    }
    static Upward square(Upward a) {
        const double least = smaller(smaller(a.low, a.hi), 0.0), most = larger(a.low, a.hi);
        return {least * -least, most * most};
    }
    static Upward divide(Upward a, Upward b) {
        const bool negative = b.hi < 0;
        const double n_low = negative ? a.hi : a.low, n_hi = negative ? a.low : a.hi;
        const double d_lo = (negative ? -b.hi : -b.low) + 0.0; // + 0.0: no negative zero
        const double d_hi = (negative ? b.low : b.hi) + 0.0;
        const double low = larger(n_low / (n_low > 0 ? d_lo : d_hi), -Plain::saturation());
        const double hi = larger(n_hi / (n_hi < 0 ? d_hi : d_lo), -Plain::saturation());
        const double unbounded = d_lo == 0 ? smaller(n_low, n_hi) : -d_lo;
        return {unbounded < 0 && low <= Plain::saturation() ? low : infinity,
                unbounded < 0 && hi <= Plain::saturation() ? hi : infinity};
    }
    static Upward min(Upward a, Upward b) { return {larger(a.low, b.low), smaller(a.hi, b.hi)}; }
    static Upward max(Upward a, Upward b) { return {smaller(a.low, b.low), larger(a.hi, b.hi)}; }
    static Upward select(Upward a, Upward b, Upward then, Upward otherwise) {
        const Upward both{larger(then.low, otherwise.low), larger(then.hi, otherwise.hi)};
        return a.hi < -b.low ? then : -a.low >= b.hi ? otherwise : both;
    }
    static Upward least_of_none() { return Plain::least_of_none(); }
};

} // namespace isomotion::formula
