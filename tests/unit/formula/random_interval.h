// Random intervals and members of them, most of them where operations go wrong.
#pragma once

#include <cmath>
#include <numbers>

#include "exact.h"
#include "testing.h"

namespace isomotion::formula {

class IntervalGenerator {
public:
    explicit IntervalGenerator(std::uint64_t seed)
        : random_(seed) {}

    int below(int bound) { return random_.below(bound); }

    // Two thirds are special, a third of those a few doubles beside.
    double number() {
        if (random_.below(3) == 0) return ordinary();
        double x = special();
        for (int step = random_.below(3) == 0 ? random_.below(4) : 0; step > 0; --step)
            x = std::nextafter(x, random_.below(2) == 0 ? -infinity : infinity);
        return std::clamp(x, -largest_finite, largest_finite);
    }

    Interval interval() {
        const double a = number();
        double b = a;
        switch (random_.below(8)) {
        case 0: // a point
            break;
        case 1: // a few doubles
            for (int step = 1 + random_.below(4); step > 0; --step) b = std::nextafter(b, infinity);
            break;
        case 2: // short
            b = a + std::abs(a) * std::exp2(random_.in(-52, -2));
            break;
        case 3:
            return unbounded(a);
        default:
            b = number();
        }
        const auto [low, high] = std::minmax(a, b);
        return {std::min(low, largest_finite), std::min(high, infinity)};
    }

    // One of the few exponents, sometimes an interval of them.
    Interval exponent() {
        static constexpr double usual[]{0, 0.5, 1, 2, 3, 200, -1, -2, -0.5, 1e-300, 1e17, -1e17};
        if (random_.below(4) == 0) return interval();
        const double a = usual[random_.below(std::size(usual))];
        if (random_.below(3) > 0) return a;
        const double b = usual[random_.below(std::size(usual))];
        return {std::min(a, b), std::max(a, b)};
    }

    // Not only doubles: multiples of pi/2 and extrema of T_n too, as far as 200 bits go.
    Exact member(Interval a) {
        for (int attempt = 0; attempt < 4; ++attempt) {
            const Exact x = candidate(a);
            if (holds(a, x)) return x;
        }
        return mid(a);
    }

    // A part of a, none of its ends so near to one of a's that the C library could take them for
    // each other, unless they are equal.
    Interval part(Interval a) {
        const auto inside = [&](double end) {
            const double x = member(a).rounded();
            const bool near = std::abs(x - end) <= 0x1p-40 * std::abs(x);
            return near || !contains(a, x) || std::isinf(x) ? end : x;
        };
        Interval result{inside(a.lo), inside(a.hi)};
        return result.lo <= result.hi && contains(a, result) ? result : a;
    }

private:
    double ordinary() {
        switch (random_.below(3)) {
        case 0:
            return random_.in(-3, 3);
        case 1:
            return random_.in(-100, 100);
        default:
            return (random_.below(2) == 0 ? 1 : -1) * std::exp2(random_.in(-1074, 1023.9));
        }
    }

    double special() {
        static constexpr double fixed[]{0,
                                        1,
                                        2,
                                        0.5,
                                        3,
                                        200,
                                        709.78,
                                        745.13,
                                        690.77,
                                        22,
                                        1e8,
                                        1e15,
                                        0x1p53,
                                        1e22,
                                        1e300,
                                        2e300,
                                        1e154,
                                        1e-154,
                                        1e-300,
                                        0x1p-1022,
                                        0x1p-1021,
                                        0x1p-970,
                                        smallest_positive,
                                        1e-320,
                                        largest_finite,
                                        0x1p-27,
                                        1e-8};
        const double sign = random_.below(2) == 0 ? 1 : -1;
        switch (random_.below(4)) {
        case 0:
            return sign * half_turns() * (std::numbers::pi / 2);
        case 1:
            return extremum().rounded();
        default:
            return sign * fixed[random_.below(std::size(fixed))];
        }
    }

    double half_turns() { return random_.below(random_.below(2) == 0 ? 9 : 100'000); }

    Exact extremum() {
        const int n = 2 + random_.below(random_.below(2) == 0 ? 6 : 60);
        const Exact angle = Exact::pi() * Exact(random_.below(n + 1)) / Exact(n);
        return apply(Op::cos, angle);
    }

    Interval unbounded(double a) {
        switch (random_.below(3)) {
        case 0:
            return {a, infinity};
        case 1:
            return {-infinity, a};
        default:
            return Interval::entire();
        }
    }

    Exact candidate(Interval a) {
        const double low = std::max(a.lo, -largest_finite), high = std::min(a.hi, largest_finite);
        switch (random_.below(6)) {
        case 0:
            return low;
        case 1:
            return high;
        case 2: { // a multiple of pi/2 near some point of it
            const double quarter = std::numbers::pi / 2, at = mid(a) / quarter;
            const double within = std::min(50.0, (high / 2 - low / 2) / quarter);
            const double k =
                std::isfinite(at) ? std::round(at + 2 * random_.in(-within, within)) : 0;
            return Exact(k) * Exact::pi() / Exact(2);
        }
        case 3:
            return random_.below(2) == 0 ? extremum() : Exact(special());
        case 4: // beyond all doubles
            if (a.hi == infinity) return Exact(largest_finite) * Exact(1e30);
            if (a.lo == -infinity) return Exact(-largest_finite) * Exact(1e30);
            return mid(a);
        default: {
            const Exact part = random_.in(0, 1);
            return Exact(low) + (Exact(high) - Exact(low)) * part;
        }
        }
    }

    Random random_;
};

} // namespace isomotion::formula
