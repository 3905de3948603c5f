#include "formula/interval/interval_operations.h"

#include <numbers>
#include <utility>

namespace isomotion::formula {
namespace {

using Do = Operations<Interval>;

// What the C library returns is trusted to 4 ulps; exp is not the library's but the project's own
// (exponential.h). glibc lists 1 ulp for log, pow, sin, cos, tan, asin, acos, atan and erf in
// double and 2 for sinh, cosh, tanh, asinh and acosh, counted from the correctly rounded result
// (libm-test-ulps of x86_64); the worst that a search found is 2.3, for acosh (Zimmermann, Accuracy
// of Mathematical Functions). Those are observations, not proofs, hence the margin. An ulp is at
// most 2^-52 of the result, and smallest_positive among the subnormals.
double error_of(double result) { return std::abs(result) * 0x1p-50 + 4 * smallest_positive; }
double below(double result) {
    return smaller(result, largest_finite) - error_of(smaller(result, largest_finite));
}
double above(double result) {
    return larger(result, -largest_finite) + error_of(larger(result, -largest_finite));
}

// For functions that return 0 only where they are 0: their sign is right.
Interval around(double low, double high) {
    return {low >= 0 ? larger(below(low), 0.0) : below(low),
            high <= 0 ? smaller(above(high), 0.0) : above(high)};
}

// a / pi. Its rounding, and those of may_hold(), are below 2^-51 |a / pi| + 2^-51; twice that is
// counted.
Interval half_turns(Interval a) {
    const double lo = a.lo * std::numbers::inv_pi, hi = a.hi * std::numbers::inv_pi;
    return {lo - (std::abs(lo) * 0x1p-50 + 0x1p-50), hi + (std::abs(hi) * 0x1p-50 + 0x1p-50)};
}

// May there be an integer j with first + j / frequency in `turns`? In doubt yes.
bool may_hold(Interval turns, double first, double frequency) {
    return std::floor((turns.hi - first) * frequency) >= (turns.lo - first) * frequency;
}

// sin or cos, which has its crests at (crest + 2j) pi. Doubt about one that is just outside costs
// the square of the doubt.
Interval wave(double (*f)(double), double crest, Interval a) {
    const Interval turns = half_turns(a);
    const bool has_crest = may_hold(turns, crest, 0.5);
    const bool has_trough = may_hold(turns, crest + 1, 0.5);
    if (has_crest && has_trough) return {-1, 1};
    const double low = f(a.lo), high = f(a.hi);
    const Interval between = around(smaller(low, high), larger(low, high));
    return {has_trough ? -1.0 : larger(between.lo, -1.0),
            has_crest ? 1.0 : smaller(between.hi, 1.0)};
}

constexpr double below_pi = 0x1.921fb54442d18p+1, above_pi = 0x1.921fb54442d19p+1;

double clamp_unit(double a) { return smaller(larger(a, -1.0), 1.0); }

// a^b for a >= 0, with 0^b as Operations says, but unbounded for b < 0.
double power_of(double a, double b) {
    if (a > 0) return std::pow(a, b);
    return b > 0 ? 0 : b == 0 ? 1 : infinity;
}

// a >= 0. In a, and in b, powers rise or fall throughout: they are extreme in the corners.
Interval power_of(Interval a, Interval b) {
    double least = power_of(a.lo, b.lo), most = power_of(a.hi, b.lo);
    if (most < least) std::swap(least, most);
    if (!is_point(b)) {
        for (const double corner : {power_of(a.lo, b.hi), power_of(a.hi, b.hi)}) {
            least = smaller(least, corner);
            most = larger(most, corner);
        }
    }
    return {larger(below(least), 0.0), above(most)};
}

// The library's cbrt may be off by 4 ulps. A step of Newton's method with what r^3 is off by,
// itself almost without rounding, leaves less than one.
double third_root(double a) {
    const double r = std::cbrt(a);
    if (r == 0 || std::isinf(r)) return r;
    const double square = r * r, lost = std::fma(r, r, -square);
    const double excess = std::fma(square, r, -a) + lost * r;
    return r - excess / (3 * square);
}

} // namespace

Interval Do::log(Interval a) {
    if (a.lo < 0) return Interval::entire();
    return saturate(around(std::log(a.lo), std::log(a.hi)));
}

Interval Do::sin(Interval a) {
    return wave([](double x) { return std::sin(x); }, 0.5, a);
}

Interval Do::cos(Interval a) {
    return wave([](double x) { return std::cos(x); }, 0, a);
}

Interval Do::tan(Interval a) {
    if (may_hold(half_turns(a), 0.5, 1)) return Interval::entire();
    return around(std::tan(a.lo), std::tan(a.hi));
}

Interval Do::sinh(Interval a) { return saturate(around(std::sinh(a.lo), std::sinh(a.hi))); }

Interval Do::cosh(Interval a) {
    return saturate({larger(below(std::cosh(mignitude(a))), 1.0), above(std::cosh(magnitude(a)))});
}

Interval Do::tanh(Interval a) {
    const Interval t = around(std::tanh(a.lo), std::tanh(a.hi));
    return {larger(t.lo, -1.0), smaller(t.hi, 1.0)};
}

Interval Do::asin(Interval a) {
    return around(std::asin(clamp_unit(a.lo)), std::asin(clamp_unit(a.hi)));
}

Interval Do::acos(Interval a) {
    return around(std::acos(clamp_unit(a.hi)), std::acos(clamp_unit(a.lo)));
}

Interval Do::atan(Interval a) { return around(std::atan(a.lo), std::atan(a.hi)); }

Interval Do::asinh(Interval a) { return around(std::asinh(a.lo), std::asinh(a.hi)); }

Interval Do::acosh(Interval a) {
    return around(std::acosh(larger(a.lo, 1.0)), std::acosh(larger(a.hi, 1.0)));
}

Interval Do::erf(Interval a) {
    const Interval e = around(std::erf(a.lo), std::erf(a.hi));
    return {larger(e.lo, -1.0), smaller(e.hi, 1.0)};
}

Interval Do::cbrt(Interval a) { return around(third_root(a.lo), third_root(a.hi)); }

// On a box without the axis, angles are extreme in two corners.
Interval Do::angle(Interval a, Interval b) {
    // An angle that underflows has the sign of a.
    const auto between = [](double low_a, double low_b, double high_a, double high_b) {
        const double low = Operations<double>::atan2(low_a, low_b),
                     high = Operations<double>::atan2(high_a, high_b);
        return Interval(low_a >= 0 ? larger(below(low), 0.0) : below(low),
                        high_a <= 0 && high <= 0 ? smaller(above(high), 0.0) : above(high));
    };
    if (b.lo > 0) return between(a.lo, a.lo >= 0 ? b.hi : b.lo, a.hi, a.hi >= 0 ? b.lo : b.hi);
    if (a.lo > 0) return between(b.hi >= 0 ? a.lo : a.hi, b.hi, b.lo >= 0 ? a.hi : a.lo, b.lo);
    if (a.hi < 0) return between(b.lo >= 0 ? a.lo : a.hi, b.lo, b.hi >= 0 ? a.hi : a.lo, b.hi);
    if (!(b.hi < 0)) return {-above_pi, above_pi};
    // From the upper side of the cut to the lower one, as far from above pi as that is from pi.
    const Interval upper = between(a.hi, b.hi, 0, b.hi), lower = between(-a.lo, b.hi, 0, b.hi);
    return {upper.lo, (Interval(2 * below_pi, 2 * above_pi) - lower).hi};
}

Interval Do::atan2(Interval a, Interval b) {
    const bool is_cut = a.lo < 0 && a.hi >= 0 && b.lo <= 0;
    if (is_cut) return {-above_pi, above_pi};
    const Interval all = angle(a, b);
    return {larger(all.lo, a.lo >= 0 ? 0.0 : -above_pi), smaller(all.hi, above_pi)};
}

Interval Do::power(Interval a, Interval b) {
    if (b == Interval(0.0)) return 1.0;
    if (a.lo >= 0) return saturate(power_of(a, b));
    // Negative numbers have powers at integers.
    const double n = b.lo;
    if (!is_point(b) || n != std::floor(n)) return Interval::entire();
    if (std::fmod(n, 2) == 0) return saturate(power_of(abs(a), b));
    if (n > 0) {
        const double low = power_of(-a.lo, n), high = power_of(std::abs(a.hi), n);
        return saturate({-above(low), a.hi < 0 ? -larger(below(high), 0.0) : above(high)});
    }
    // Below 0 down to minus infinity, but large and positive at 0.
    return a.hi < 0 ? saturate(-power_of(-a, b)) : Interval::entire();
}

} // namespace isomotion::formula
