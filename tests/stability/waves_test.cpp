// Waves and bumps that are shorter than a step, with flat ground or other waves between them:
// formula/cubic_steps.h.
#include "stability/hard_case.h"

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

class Waves : public Stability {};

TEST_P(Waves, KeepWithinTheirBounds) { expect_bounds(GetParam()); }

HardCase waves(const char* name, const char* formula, double radius) {
    return {name,
            fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ sphere = {} }}\n"
                        "[camera]\nazimuth = 71\nelevation = -12\n",
                        formula, radius),
            {}};
}

INSTANTIATE_TEST_SUITE_P(
    Stability, Waves,
    testing::Values(
        waves("lattice", "sin(30*x)*sin(30*y)*sin(30*z) - 0.6", 1.3),
        waves("sharp gyroid",
              "(2*(cos(11*x)*cos(11*y) + cos(11*y)*cos(11*z) + cos(11*z)*cos(11*x)) - "
              "cos(22*x) - cos(22*y) - cos(22*z))^2 - 0.25",
              1.9),
        waves("chirp", "sin(20*x*y*z) - 0.5", 3),
        waves("egg box", "z - 0.1*sin(30*x)*sin(30*y)", 2),
        waves("peaks",
              "1/(1 + 100*sin(6*x)^2) + 1/(1 + 100*sin(6*y)^2) + "
              "1/(1 + 100*sin(6*z)^2) - 1.2",
              1.5),
        waves("bumps", "exp(-50*sin(4*x)^2)*exp(-50*sin(4*y)^2)*exp(-50*sin(4*z)^2) - 0.5", 2),
        waves("thin gyroid",
              "sqrt((sin(20*x)*cos(20*y) + sin(20*y)*cos(20*z) + "
              "sin(20*z)*cos(20*x))^2 + 0.0001) - 0.03",
              2.5),
        waves("cut lattice", "max(sin(40*x)*sin(40*y)*sin(40*z) - 0.9, z - 0.7)", 1.5),
        waves("lattice and ball",
              "min(sin(40*x)*sin(40*y)*sin(40*z) + 0.93, sqrt(x^2 + y^2 + z^2) - 0.4)", 1.5),
        waves("kinked waves", "abs(sin(20*x)) + abs(sin(20*y)) + abs(sin(20*z)) - 2.9", 1.5)),
    test_name);

} // namespace
} // namespace isomotion::stability
