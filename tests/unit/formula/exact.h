// What the operations of formulas mean on real numbers, to 200 bits: the oracle for intervals.
#pragma once

#include <mpfr.h>

#include <cmath>
#include <iosfwd>
#include <utility>

#include "formula/graph/graph.h"
#include "formula/interval/interval.h"

namespace isomotion::formula {

// An MPFR number with value semantics.
class Exact {
public:
    Exact(double value = 0) {
        mpfr_init2(x_, precision);
        mpfr_set_d(x_, value, MPFR_RNDN);
    }
    Exact(const Exact& other) {
        mpfr_init2(x_, precision);
        mpfr_set(x_, other.x_, MPFR_RNDN);
    }
    Exact& operator=(const Exact& other) {
        mpfr_set(x_, other.x_, MPFR_RNDN);
        return *this;
    }
    ~Exact() { mpfr_clear(x_); }

    static Exact undefined() { return std::nan(""); }
    static Exact pi() {
        Exact result;
        mpfr_const_pi(result.x_, MPFR_RNDN);
        return result;
    }

    mpfr_ptr get() { return x_; }
    mpfr_srcptr get() const { return x_; }
    double rounded() const { return mpfr_get_d(x_, MPFR_RNDN); }
    bool is_undefined() const { return mpfr_nan_p(x_); }
    bool is_integer() const { return mpfr_integer_p(x_); }

    friend bool operator<(const Exact& a, const Exact& b) { return mpfr_less_p(a.x_, b.x_); }
    friend bool operator==(const Exact& a, const Exact& b) { return mpfr_equal_p(a.x_, b.x_); }

    static constexpr mpfr_prec_t precision = 200;

private:
    mpfr_t x_;
};

template<class F, class... A> Exact computed(F function, const A&... arguments) {
    Exact result;
    function(result.get(), arguments.get()..., MPFR_RNDN);
    return result;
}
inline Exact operator+(const Exact& a, const Exact& b) { return computed(mpfr_add, a, b); }
inline Exact operator-(const Exact& a, const Exact& b) { return computed(mpfr_sub, a, b); }
inline Exact operator*(const Exact& a, const Exact& b) { return computed(mpfr_mul, a, b); }
inline Exact operator/(const Exact& a, const Exact& b) { return computed(mpfr_div, a, b); }
inline Exact operator-(const Exact& a) { return Exact(0) - a; }

std::ostream& operator<<(std::ostream& out, const Exact& a);
void PrintTo(const Interval& a, std::ostream* out);

// The operation on paper, with what Operations adds to it: sqrt, asin, acos, acosh and powers of 0
// beyond where they are defined, and 10^300 for infinity. Not cut off anywhere else. Undefined
// where Operations<double> is NaN.
Exact apply(Op op, const Exact& a);
Exact apply(Op op, const Exact& a, const Exact& b);
Exact chebyshev(int n, int k, const Exact& x); // the k-th derivative of T_n

// +-10^300 for what is further out, the way Operations<double> computes.
Exact saturated(const Exact& a);

// True if the value is in the interval; an undefined one, if the interval is the entire line.
bool holds(Interval interval, const Exact& value);

} // namespace isomotion::formula
