// exp of a double with a proved error bound, without branches: loops over it vectorise, and its
// values are the same on every processor.
#pragma once

#include <bit>
#include <cstdint>

namespace isomotion::formula {

// Within 2^-51 of itself of e^x for -708 <= x <= 709, where the result is a normal number; x must
// lie there.
//
// e^x = 2^n e^r with n the integer next to x/ln 2 and |r| <= 0.35, and e^r by its Taylor
// polynomial of degree 13. Let u = 2^-53. Relative to e^r:
//   the polynomial leaves out less than |r|^14/14! e^|r|/e^r < 2^-56;
//   ln 2 is split into `high`, of 41 bits, so that n high is exact (|n| < 2^11), and `low`, nearly
//   its rest. x - n high is below 0.36 and a multiple of the last place of x or, if n is not 0, of
//   2^-42 high's last: exact (for |n| >= 1 the two are within a factor of 2, Sterbenz). n low is
//   below 2^-31, so its rounding, and what low misses of the rest (below 2^-95), are below 2^-84
//   in all; subtracting it is rounded by u/4 at most, as |r| < 0.5. So r is off by u/3;
//   the last step of Horner's scheme adds 1 and r s, with s within 1.25 and itself off by less than
//   2 u: the product by 0.35 * 2u + 0.44 u / 2 and the sum by u at most (below 2), or u/2 (below 1,
//   where e^r is at least 0.7).
// The whole is below 2^-56 + u/3 + (0.7 u + 0.22 u + u) / 0.7 < 4 u = 2^-51. Scaling is exact.
inline double exponential(double x) {
    constexpr double log2_e = 0x1.71547652b82fep+0;
    constexpr double high = 0x1.62e42fefa3p-1, low = 0x1.3de6af278ece6p-42;
    // Adding this rounds to an integer, which the last bits of the sum then hold.
    constexpr double to_integer = 0x1.8p52;
    const double shifted = x * log2_e + to_integer;
    const double n = shifted - to_integer;
    const double r = (x - n * high) - n * low;
    double s = 1.0 / 6227020800;
    s = s * r + 1.0 / 479001600;
    s = s * r + 1.0 / 39916800;
    s = s * r + 1.0 / 3628800;
    s = s * r + 1.0 / 362880;
    s = s * r + 1.0 / 40320;
    s = s * r + 1.0 / 5040;
    s = s * r + 1.0 / 720;
    s = s * r + 1.0 / 120;
    s = s * r + 1.0 / 24;
    s = s * r + 1.0 / 6;
    s = s * r + 1.0 / 2;
    s = s * r + 1.0;
    s = s * r + 1.0;
    const auto bits = std::bit_cast<std::uint64_t>(shifted) << 52;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(s) + bits);
}

} // namespace isomotion::formula
