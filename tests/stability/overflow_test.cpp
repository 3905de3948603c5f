// Values beyond what float holds, and ones that vanish before they should.
#include "stability/hard_case.h"

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

class Overflow : public Stability {};

TEST_P(Overflow, KeepWithinTheirBounds) { expect_bounds(GetParam()); }

HardCase extreme(const std::string& name, const std::string& formula, double bound, double camera,
                 double step, double sign, double taylor) {
    return {name,
            fmt::format(R"(
[surface]
formula = "{}"
bounds = {{ sphere = {} }}
[camera]
position = [{}, 0, 0]
target = [0, 0, 0]
up = [0, 0, 1]
[isolation]
step = {}
[output]
size = [97, 97]
)",
                        formula, bound, camera, step),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}},
            {},
            /*by_default=*/0,
            /*is_cut_off=*/true};
}

INSTANTIATE_TEST_SUITE_P(
    Stability, Overflow,
    testing::Values(
        // exp(-1600) is 0, and so is its slope.
        extreme("Gaussian in wide bounds", "exp(-(x^2 + y^2 + z^2)) - 0.5", 40, 100, 0.1, 0, 0),
        extreme("Gaussian that grows", "exp(x^2 + y^2 + z^2) - 2", 40, 100, 0.1, 0, 380),
        // exp(z)*cos(y) beyond z = 88 would be inf - inf.
        extreme("Scherk in wide bounds", "exp(z)*cos(y) - cos(x)", 150, 400, 0.2, 0, 0),
        // T_50(6) is 10^53.
        extreme("T_50 to x = 6", "chebyshev(50, x) + chebyshev(50, y) + chebyshev(50, z)", 6, 20,
                0.004, 0, 0),
        // T_49 is odd: beyond x = 2 values that float does not hold meet with both signs, and what
        // is seen there is no surface; up to there it is. No NaN in either.
        extreme("T_49 to x = 1.9", "chebyshev(49, x) + chebyshev(49, y) + chebyshev(49, z)", 1.9, 6,
                0.001, 0, 760),
        extreme("T_49 to x = 6", "chebyshev(49, x) + chebyshev(49, y) + chebyshev(49, z)", 6, 20,
                0.004, 440000, 510000),
        // Slopes are infinite, or none, before values are.
        extreme("T_22 to x = 40", "chebyshev(22, x) + chebyshev(22, y) + chebyshev(22, z)", 40, 130,
                0.1, 0, 0),
        // Values are cut off beyond r = 8.3, and slopes go on.
        extreme("Gaussian that grows far", "exp(x^2 + y^2 + z^2) - 3", 60, 200, 0.1, 0, 320000),
        extreme("exponentials in wide bounds", "exp(x*y) + exp(y*z) + exp(z*x) - 4", 60, 200, 0.1,
                0, 0),
        // exp(-100) comes to 0 in float32, and so did F where x isn't 0 (graph/same_signs.h).
        extreme("plane that fades", "x*exp(-(x^2 + y^2 + z^2))", 10, 30, 0.1, 0, 0),
        extreme("charges", "exp(-9*((x - 1)^2 + y^2 + z^2)) - exp(-9*((x + 1)^2 + y^2 + z^2))", 4,
                12, 0.05, 0, 0),
        // exp(-64*2) comes to 0, too, and so did the body beyond (graph/log_sums.h).
        extreme("bodies blended by a logarithm",
                "-log(exp(-64*(sqrt((x - 0.5)^2 + y^2) - 0.4)) + exp(-64*(sqrt((x + 0.4)^2 + y^2 + "
                "z^2) - 0.3)))/64",
                1.8, 6, 0.02, 0, 0),
        extreme("blend of a blend",
                "-log(exp(-1000*(-log(exp(-1000*x) + exp(-1000*y))/1000)) + exp(-1000*z))/1000",
                1.5, 5, 0.02, 0, 0),
        // F and its slopes are finite, and its second derivative is not.
        extreme("three steep planes",
                "(exp(40*x) - 1)*(exp(40*x) - 3)*(exp(40*(x - 0.2)) - 2) + 0.001*y", 9, 30, 0.05, 0,
                460000),
        extreme("pole at the middle", "1/(x^2 + y^2 + z^2) - 1", 3, 8, 0.02, 0, 0),
        // Linear extensions from a pole reach zero at once: Taylor's test is blind there.
        extreme("from inside the pole", "1/(x^2 + y^2 + z^2) - 1", 3, 1e-9, 0.02, 0, blind),
        extreme("power 200 in wide bounds", "abs(x)^200 + abs(y)^200 + abs(z)^200 - 1", 6, 20, 0.02,
                0, 110000),
        // 0.1^60 is 0 in float32, and so was the norm (graph/power_sums.h). Its edges are sharp for
        // Taylor's test.
        extreme("ring of square section",
                "(abs(sqrt(x^2 + y^2) - 0.85)^60 + abs(z)^60)^(1/60) - 0.2", 1.3, 4, 0.02, 0, 3500),
        // 5^60 is no number in float32, and the powers of other formulas are cut off.
        extreme("cube of a high power", "(x^60 + y^60 + z^60)^(1/60) - 5", 9, 30, 0.1, 0, 0),
        extreme("box with a round top", "(abs(x)^40 + abs(y)^40)^0.05 + z^2 - 0.5", 1.2, 4, 0.02, 0,
                0),
        // Its slopes are of every size, where Taylor's test extends them to 0.
        extreme("power of a power", "(abs(x)^18.9 + abs(y)^18.9)^9.7 + abs(z)^1.8 - 1", 1.8, 6,
                0.02, 0, 540000),
        extreme("power -200", "abs(x)^-200 + abs(y)^-200 + abs(z)^-200 - 3", 6, 20, 0.02, 0, 0),
        extreme("values of 10^-30", "1e-30*(x^2 + y^2 + z^2 - 1)", 1.5, 5, 0.02, 0, 0),
        extreme("values of 10^25", "1e25*(x^2 + y^2 + z^2 - 1)", 1.5, 5, 0.02, 0, 0)),
    test_name);

} // namespace
} // namespace isomotion::stability
