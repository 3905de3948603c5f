// Each operation of formulas on ranges of floats, see float_range.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "float_range.h"

namespace isomotion::shader::ranges {

inline constexpr double unit = 0x1p-24;
inline constexpr double reordered = 4; // what another order of a sum costs
inline constexpr double saturation = 1e30f;
inline constexpr double largest = std::numeric_limits<float>::max();
inline constexpr double smallest = std::numeric_limits<float>::min();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline double saturate(double v) { return std::clamp(v, -saturation, saturation); }
inline double size(const Range& a) { return std::max(std::abs(a.low), std::abs(a.high)); }
inline bool is_point(const Range& a) { return a.low == a.high; }
inline bool holds_zero(const Range& a) { return a.contains(0); }
inline Range anything() { return {-infinity, infinity, true}; }

inline Range hull(std::initializer_list<double> values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
}

inline Range hull(const Range& a, const Range& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), a.nan || b.nan};
}

// Grows by an error at each end, then over what floats cannot tell apart.
inline Range grown(Range a, double below, double above) {
    if (std::isnan(a.low) || std::isnan(a.high)) return anything();
    if (std::isfinite(a.low)) a.low -= below;
    if (std::isfinite(a.high)) a.high += above;
    if (a.high > largest) a.high = infinity;
    if (a.low < -largest) a.low = -infinity;
    if (a.low > 0 && a.low < smallest) a.low = 0;
    if (a.high < 0 && a.high > -smallest) a.high = 0;
    return a;
}

inline Range relative(Range a, double units) {
    return grown(a, units * unit * std::abs(a.low), units * unit * std::abs(a.high));
}

// Numbers of few digits: what is made of them comes out exactly, in whatever order.
inline bool is_short(const Range& a) {
    return is_point(a) && std::abs(a.low) <= 1024 && std::floor(a.low * 1024) == a.low * 1024;
}

inline Range rounded(const Range& a) { return relative(a, is_short(a) ? 0 : 1); }

inline Range negate(const Range& a) { return {-a.high, -a.low, a.nan}; }

inline Range add(const Range& a, const Range& b) {
    Range sum{a.low + b.low, a.high + b.high, a.nan || b.nan};
    const bool opposite =
        (a.high == infinity && b.low == -infinity) || (a.low == -infinity && b.high == infinity);
    if (opposite) return anything();
    if (is_short(a) && is_short(b)) return sum;
    return grown(sum, reordered * unit * (std::abs(a.low) + std::abs(b.low)),
                 reordered * unit * (std::abs(a.high) + std::abs(b.high)));
}

inline Range multiply(const Range& a, const Range& b) {
    const bool unbounded = size(a) == infinity || size(b) == infinity;
    if (unbounded && (holds_zero(a) || holds_zero(b))) return anything();
    Range product = hull({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    product.nan = a.nan || b.nan;
    return rounded(product);
}

inline Range divide(const Range& a, const Range& b) {
    if (!holds_zero(b)) {
        if (size(a) == infinity && size(b) == infinity) return anything();
        Range quotient = hull({saturate(a.low / b.low), saturate(a.low / b.high),
                               saturate(a.high / b.low), saturate(a.high / b.high)});
        quotient.nan = a.nan || b.nan;
        return rounded(quotient);
    }
    const bool nan = a.nan || b.nan || holds_zero(a);
    if (is_point(b) && a.low > 0) return {saturation, saturation, nan};
    if (is_point(b) && a.high < 0) return {-saturation, -saturation, nan};
    return {-saturation, saturation, nan};
}

inline Range abs(const Range& a) {
    if (holds_zero(a)) return {0, size(a), a.nan};
    return {std::min(std::abs(a.low), std::abs(a.high)), size(a), a.nan};
}

inline Range sign(const Range& a) {
    const auto of = [](double v) { return double(v > 0) - double(v < 0); };
    return {of(a.low), of(a.high), a.nan};
}

inline Range min(const Range& a, const Range& b) {
    return {std::min(a.low, b.low), std::min(a.high, b.high), a.nan || b.nan};
}

inline Range max(const Range& a, const Range& b) {
    return {std::max(a.low, b.low), std::max(a.high, b.high), a.nan || b.nan};
}

inline Range select(const Range& a, const Range& b, const Range& then, const Range& otherwise) {
    const bool open = a.nan || b.nan;
    if (!open && a.high < b.low) return then;
    if (!open && a.low >= b.high) return otherwise;
    return hull(then, otherwise);
}

// A kernel of an increasing function that is off by `units` of its result.
template<class F> Range increasing(const Range& a, double units, F f) {
    return relative({f(a.low), f(a.high), a.nan}, units);
}

inline Range log(const Range& a) {
    if (a.high < 0) return anything();
    const auto f = [](double v) {
        if (v > largest) return saturation;
        return v <= 0 ? -saturation : std::log(v);
    };
    Range result = increasing(a, 3, f);
    result.nan = a.nan || a.low < 0;
    return result;
}

inline Range cosh(const Range& a) {
    return increasing(abs(a), 4, [](double v) { return saturate(std::cosh(v)); });
}

inline Range acos(const Range& a) {
    const auto f = [](double v) { return std::acos(std::clamp(v, -1.0, 1.0)); };
    return relative({f(a.high), f(a.low), a.nan}, 8);
}

// Up to 1e5 the argument of sin, cos and tan is reduced exactly; from there it is off by two
// spacings.
inline double reduction_error(const Range& a) { return size(a) > 1e5 ? 4 * unit * size(a) : 0; }

template<class F> Range wave(const Range& a, double error, F f) {
    if (size(a) == infinity) return anything();
    const double reach = 0.5 * (a.high - a.low) + error + reduction_error(a);
    const double middle = f(0.5 * (a.low + a.high));
    return {std::max(-1.0, middle - reach), std::min(1.0, middle + reach), a.nan};
}

inline Range sin(const Range& a) {
    return wave(a, 3 * unit * std::min(1.0, size(a)), [](double v) { return std::sin(v); });
}

inline Range cos(const Range& a) {
    return wave(a, 3 * unit, [](double v) { return std::cos(v); });
}

inline Range tan(const Range& a) {
    using std::numbers::pi;
    if (size(a) == infinity) return anything();
    const double reach = size(a) > 1.5 ? 3 * unit + reduction_error(a) : 0;
    const double low = a.low - reach, high = a.high + reach;
    const bool pole = std::floor(low / pi - 0.5) != std::floor(high / pi - 0.5);
    if (pole) return {-saturation, saturation, a.nan};
    return relative({saturate(std::tan(low)), saturate(std::tan(high)), a.nan}, 8);
}

// a^b for a > 0 or an integer b.
inline double power(double a, double b) {
    if (b == 0) return 1;
    if (a == 0) return b > 0 ? 0 : saturation;
    return saturate(std::pow(a, b));
}

inline Range power(const Range& a, const Range& b) {
    Range result = hull({power(std::abs(a.low), b.low), power(std::abs(a.low), b.high),
                         power(std::abs(a.high), b.low), power(std::abs(a.high), b.high)});
    result.nan = a.nan || b.nan;
    if (a.low < 0) {
        const bool integer = is_point(b) && std::floor(b.low) == b.low;
        if (!integer) {
            result = hull(result, negate(result));
            result.nan = true;
        } else if (std::fmod(b.low, 2) != 0) {
            result = hull({power(a.low, b.low), power(a.high, b.low)});
        }
        if (holds_zero(a)) { // the pole or the zero between the ends
            const double top = power(0, b.low);
            result = hull(result, {std::min(0.0, top), top});
            if (top > 0) result.low = -saturation;
        }
    }
    return relative(result, 10);
}

} // namespace isomotion::shader::ranges
