// One definition of each operation for each number type.
//
// `Operations<T>` defines every Op on T. Constant folding, CPU evaluation and (by the same rules,
// in shaders/math/) the GPU follow it. The rules avoid NaN where a formula is finite on paper:
//
//   - results of exp, sinh, cosh, tan, log, power and divide are cut off at +-saturation, so that
//     0 * exp(100) is 0 and not NaN;
//   - sqrt of a negative number is 0, since rounding makes radicands negative; so is acosh below 1;
//   - 0^b is 0, 1 or saturation; a negative base has a power if the exponent is an integer;
//   - x/0 is +-saturation; 0/0 stays NaN;
//   - the angle at the axis is 0, and -0 is 0: it does not choose a side of the cut.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "formula/graph/exponential.h"

namespace isomotion::formula {

template<class T> struct Operations {
    static_assert(std::is_floating_point_v<T>);

    // Far enough below the largest number that products of a saturated value with a coefficient,
    // and sums over thousands of terms, stay finite. The float value is IM_SATURATION in the
    // shaders. Values of an animation are doubles; one that is cut off exceeds floats and is
    // reported. Intervals hold the values cut off in float, those cut off in double, and the exact
    // value.
    static constexpr T saturation() { return std::is_same_v<T, float> ? T(1e30) : T(1e300); }
    static T saturate(T a) { // NaN passes through
        return a > saturation() ? saturation() : a < -saturation() ? -saturation() : a;
    }

    static T negate(T a) { return -a; }
    static T abs(T a) { return std::abs(a); }
    static T sign(T a) { return a > 0 ? T(1) : a < 0 ? T(-1) : a == 0 ? T(0) : a; }
    static T sqrt(T a) { return a < 0 ? T(0) : std::sqrt(a); }
    static T exp(T a) {
        if constexpr (std::is_same_v<T, double>) {
            // Loops over this function vectorise. Results below the normal numbers are 0.
            const double near = exponential(a < -708 ? -708 : a > 700 ? 700 : a);
            // NaN differs from itself. NOLINTNEXTLINE(misc-redundant-expression)
            return a < -708 ? 0 : a != a ? a : near < saturation() ? near : saturation();
        } else {
            return saturate(std::exp(a));
        }
    }
    static T log(T a) { return a == 0 ? -saturation() : saturate(std::log(a)); }
    static T sin(T a) { return std::sin(a); }
    static T cos(T a) { return std::cos(a); }
    static T tan(T a) { return saturate(std::tan(a)); }
    static T sinh(T a) { return saturate(std::sinh(a)); }
    static T cosh(T a) { return saturate(std::cosh(a)); }
    static T tanh(T a) { return std::tanh(a); }
    static T asin(T a) { return std::asin(clamp_unit(a)); }
    static T acos(T a) { return std::acos(clamp_unit(a)); }
    static T atan(T a) { return std::atan(a); }
    static T floor(T a) { return std::floor(a); }
    static T asinh(T a) { return std::asinh(a); }
    static T acosh(T a) { return a < 1 ? T(0) : std::acosh(a); }
    static T erf(T a) { return std::erf(a); }
    static T cbrt(T a) { return std::cbrt(a); }
    static T add(T a, T b) { return a + b; }
    static T subtract(T a, T b) { return a - b; }
    static T multiply(T a, T b) { return a * b; }
    static T divide(T a, T b) {
        if (b != 0) return saturate(a / b);
        return a > 0 ? saturation() : a < 0 ? -saturation() : std::numeric_limits<T>::quiet_NaN();
    }
    static T min(T a, T b) { return a < b ? a : b; }
    static T max(T a, T b) { return a < b ? b : a; }
    static T power(T a, T b) {
        if (b == 0) return T(1);
        if (a == 0) return b > 0 ? T(0) : saturation();
        return saturate(std::pow(a, b));
    }
    static T atan2(T a, T b) { return std::atan2(a == 0 ? T(0) : a, b == 0 ? T(0) : b); }
    static T angle(T a, T b) { return atan2(a, b); }
    static T select(T a, T b, T then, T otherwise) { return a < b ? then : otherwise; }
    static T least_of_none() { return saturation(); }

private:
    static T clamp_unit(T a) { return a > 1 ? T(1) : a < -1 ? T(-1) : a; }
};

} // namespace isomotion::formula
