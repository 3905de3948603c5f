// The operations of formulas on intervals.
//
// An enclosure holds the exact value and the results of Operations<float> and <double>, if these
// differ. A result that may be cut off at +-saturation has no bound on that side, and the interval
// begins no further out than saturation. Where the result is NaN in double (0/0, logarithms and
// roots other than sqrt of negative numbers), the enclosure is the entire line. Negation, abs,
// sign, floor, min, max and select are exact; + - * / and sqrt are rounded to within one or two
// doubles; exp is the function of exponential.h, within the error proved there. The others rely on
// the documented error of the C library, with a margin (interval_operations.cpp).
#pragma once

#include "formula/graph/exponential.h"
#include "formula/graph/operations.h"
#include "formula/interval/interval.h"

namespace isomotion::formula {

template<> struct Operations<Interval> {
    static constexpr double saturation() { return double(Operations<float>::saturation()); }
    static Interval saturate(Interval a) {
        const double lo = smaller(a.lo, saturation()), hi = larger(a.hi, -saturation());
        return {lo < -saturation() ? -infinity : lo, hi > saturation() ? infinity : hi};
    }

    static Interval negate(Interval a) { return -a; }
    static Interval abs(Interval a) { return {mignitude(a), magnitude(a)}; }
    static Interval sign(Interval a) {
        return {Operations<double>::sign(a.lo), Operations<double>::sign(a.hi)};
    }
    static Interval sqrt(Interval a) {
        return {round_down(std::sqrt(larger(a.lo, 0.0))), round_up(std::sqrt(larger(a.hi, 0.0)))};
    }
    // Outside the range of exponential() its values at the ends of the range hold, or 0 and
    // infinity. No branches.
    static Interval exp(Interval a) {
        const double low = exponential(smaller(larger(a.lo, exp_low), exp_high));
        const double high = exponential(smaller(larger(a.hi, exp_low), exp_high));
        const double lo = a.lo < exp_low ? 0.0 : low - low * 0x1p-50;
        const double hi = a.hi > exp_high ? infinity : high + high * 0x1p-50;
        return saturate({lo, hi});
    }
    static Interval log(Interval a);
    static Interval sin(Interval a);
    static Interval cos(Interval a);
    static Interval tan(Interval a);
    static Interval sinh(Interval a);
    static Interval cosh(Interval a);
    static Interval tanh(Interval a);
    static Interval asin(Interval a);
    static Interval acos(Interval a);
    static Interval atan(Interval a);
    static Interval asinh(Interval a);
    static Interval acosh(Interval a);
    static Interval erf(Interval a);
    static Interval cbrt(Interval a);
    static Interval floor(Interval a) { return {std::floor(a.lo), std::floor(a.hi)}; }
    static Interval add(Interval a, Interval b) { return a + b; }
    static Interval subtract(Interval a, Interval b) { return a - b; }
    static Interval multiply(Interval a, Interval b) { return a * b; }
    static Interval square(Interval a) { return formula::square(a); }
    static Interval divide(Interval a, Interval b) { return saturate(a / b); }
    static Interval min(Interval a, Interval b) {
        return {smaller(a.lo, b.lo), smaller(a.hi, b.hi)};
    }
    static Interval max(Interval a, Interval b) { return {larger(a.lo, b.lo), larger(a.hi, b.hi)}; }
    static Interval power(Interval a, Interval b);
    static Interval atan2(Interval a, Interval b);
    // Of boxes across the cut, from below pi to above it.
    static Interval angle(Interval a, Interval b);
    static constexpr double exp_low = -708, exp_high = 709;
    static Interval select(Interval a, Interval b, Interval then, Interval otherwise) {
        return a.hi < b.lo ? then : a.lo >= b.hi ? otherwise : hull(then, otherwise);
    }
    static Interval least_of_none() { return {saturation(), infinity}; }
};

} // namespace isomotion::formula
