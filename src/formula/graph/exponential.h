// exp of a double with a proved error bound and without branches. Loops over it vectorise, and its
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
//   - The polynomial leaves out less than |r|^14/14! e^(2|r|) < u/8.
//   - ln 2 is `high`, of 41 bits, so that n high is exact (|n| < 2^11), and `low`, nearly its rest.
//     x - n high is exact, too: n is 0, or the two are within a factor of 2 (Sterbenz). n low is
//     below 2^-31; its rounding and what `low` misses are below 2^-83. Its subtraction is rounded
//     by u/4 at most, as |r| < 0.5. So r is off by less than u/3.
//   - Horner's scheme ends with 1 + r s, where s = (e^r - 1)/r is below 1.25 and itself off by less
//     than 2 u: 1.25 u by its last two roundings, and 0.35 of what is off before. So r s is off by
//     0.7 u + u/4, and the sum by u more, or u/2 if it is below 1. It is above 0.7: in all less
//     than 2.1 u.
// That is less than 4 u = 2^-51. The scaling is exact.
inline double exponential(double x) {
    constexpr double log2_e = 0x1.71547652b82fep+0;
    constexpr double high = 0x1.62e42fefa3p-1, low = 0x1.3de6af278ece6p-42;
    // Adding this rounds to an integer, which the last bits of the sum then hold.
    constexpr double to_integer = 0x1.8p52;
    const double shifted = x * log2_e + to_integer;
    const double n = shifted - to_integer;
    const double r = (x - n * high) - n * low;
    // Constants also where the compiler leaves rounding to the processor.
    constexpr double of_13 = 1.0 / 6227020800, of_12 = 1.0 / 479001600, of_11 = 1.0 / 39916800,
                     of_10 = 1.0 / 3628800, of_9 = 1.0 / 362880, of_8 = 1.0 / 40320,
                     of_7 = 1.0 / 5040, of_6 = 1.0 / 720, of_5 = 1.0 / 120, of_4 = 1.0 / 24,
                     of_3 = 1.0 / 6, of_2 = 1.0 / 2;
    double s = of_13;
    s = s * r + of_12;
    s = s * r + of_11;
    s = s * r + of_10;
    s = s * r + of_9;
    s = s * r + of_8;
    s = s * r + of_7;
    s = s * r + of_6;
    s = s * r + of_5;
    s = s * r + of_4;
    s = s * r + of_3;
    s = s * r + of_2;
    s = s * r + 1.0;
    s = s * r + 1.0;
    const auto bits = std::bit_cast<std::uint64_t>(shifted) << 52;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(s) + bits);
}

} // namespace isomotion::formula
