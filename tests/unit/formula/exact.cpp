#include "exact.h"

#include <ostream>
#include <vector>

#include <fmt/format.h>

namespace isomotion::formula {
namespace {

const double most = 1e300;

} // namespace

std::ostream& operator<<(std::ostream& out, const Exact& a) {
    char text[64];
    mpfr_snprintf(text, sizeof text, "%.30Rg", a.get());
    return out << text;
}

void PrintTo(const Interval& a, std::ostream* out) {
    *out << fmt::format("[{}, {}] = [{:a}, {:a}]", a.lo, a.hi, a.lo, a.hi);
}

Exact apply(Op op, const Exact& a) {
    const auto within_unit = [&] { return a < -1 ? Exact(-1) : Exact(1) < a ? Exact(1) : a; };
    switch (op) {
    case Op::negate:
        return -a;
    case Op::abs:
        return a < 0 ? -a : a;
    case Op::sign:
        return a < 0 ? -1 : Exact(0) < a ? 1 : 0;
    case Op::sqrt:
        return a < 0 ? Exact(0) : computed(mpfr_sqrt, a);
    case Op::exp:
        return computed(mpfr_exp, a);
    case Op::log:
        return a == 0 ? Exact(-most) : computed(mpfr_log, a);
    case Op::sin:
        return computed(mpfr_sin, a);
    case Op::cos:
        return computed(mpfr_cos, a);
    case Op::tan:
        return computed(mpfr_tan, a);
    case Op::sinh:
        return computed(mpfr_sinh, a);
    case Op::cosh:
        return computed(mpfr_cosh, a);
    case Op::tanh:
        return computed(mpfr_tanh, a);
    case Op::asin:
        return computed(mpfr_asin, within_unit());
    case Op::acos:
        return computed(mpfr_acos, within_unit());
    case Op::atan:
        return computed(mpfr_atan, a);
    case Op::asinh:
        return computed(mpfr_asinh, a);
    case Op::acosh:
        return a < 1 ? Exact(0) : computed(mpfr_acosh, a);
    case Op::erf:
        return computed(mpfr_erf, a);
    case Op::cbrt:
        return computed(mpfr_cbrt, a);
    case Op::floor: {
        Exact result;
        mpfr_floor(result.get(), a.get());
        return result;
    }
    default:
        return Exact::undefined();
    }
}

Exact apply(Op op, const Exact& a, const Exact& b) {
    switch (op) {
    case Op::add:
        return a + b;
    case Op::subtract:
        return a - b;
    case Op::multiply:
        return a * b;
    case Op::divide:
        if (!(b == 0)) return a / b;
        return Exact(0) < a ? Exact(most) : a < 0 ? Exact(-most) : Exact::undefined();
    case Op::min:
        return a < b ? a : b;
    case Op::max:
        return a < b ? b : a;
    case Op::atan2:
    case Op::angle:
        // -0 is 0.
        return a == 0 && b == 0 ? Exact(0) : computed(mpfr_atan2, a == 0 ? Exact(0) : a, b);
    case Op::power:
        if (b == 0) return 1;
        if (a == 0) return Exact(0) < b ? 0 : most;
        return computed(mpfr_pow, a, b);
    default:
        return Exact::undefined();
    }
}

// From T_m+1 = 2x T_m - T_m-1, differentiated k times.
Exact chebyshev(int n, int k, const Exact& x) {
    const auto size = std::size_t(k) + 1;
    std::vector<Exact> before(size), now(size);
    before[0] = 1;
    now[0] = x;
    if (k > 0) now[1] = 1;
    if (n == 0) return before.back();
    const Exact twice_x = x + x;
    for (int m = 1; m < n; ++m) {
        std::vector<Exact> next(size);
        for (std::size_t j = 0; j < size; ++j) {
            next[j] = twice_x * now[j] - before[j];
            if (j > 0) next[j] = next[j] + Exact(2.0 * double(j)) * now[j - 1];
        }
        before = std::move(now);
        now = std::move(next);
    }
    return now.back();
}

Exact saturated(const Exact& a) { return a < -most ? -most : Exact(most) < a ? most : a; }

bool holds(Interval interval, const Exact& value) {
    if (value.is_undefined()) return interval == Interval::entire();
    // An overflow of MPFR itself is some huge number.
    const auto infinite = [&](int sign) {
        return mpfr_inf_p(value.get()) && mpfr_sgn(value.get()) == sign;
    };
    if (infinite(1)) return interval.hi == infinity;
    if (infinite(-1)) return interval.lo == -infinity;
    return mpfr_cmp_d(value.get(), interval.lo) >= 0 && mpfr_cmp_d(value.get(), interval.hi) <= 0;
}

} // namespace isomotion::formula
