#pragma once

namespace isomotion::gpu {

/// How much arithmetic a driver does: floating-point operations a second of independent chains of
/// multiply-adds, two operations each, in shaders of the two stages. Measured in some milliseconds,
/// so a lower bound, good to a factor of two. 0 if it is not known.
struct ArithmeticSpeed {
    double in_fragments = 0;
    double in_compute = 0; ///< 0 without compute shaders
};

/// In the context that is current. Changes the bound target and texture bindings.
ArithmeticSpeed measure_arithmetic_speed();

} // namespace isomotion::gpu
