// Surfaces with creases and corners, where the gradient jumps or is infinite.
#include "stability/hard_case.h"

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

class NonSmooth : public Stability {};

TEST_P(NonSmooth, KeepWithinTheirBounds) { expect_bounds(GetParam()); }

HardCase superquadric(double m, double sign, double taylor) {
    return {fmt::format("superquadric m = {}", m),
            surface("superquadric", fmt::format("[parameters]\nm = {}\n", m)),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}}};
}

INSTANTIATE_TEST_SUITE_P(Superquadric, NonSmooth,
                         testing::Values(superquadric(0.3, 3600, 32000),
                                         superquadric(0.5, 7700, 13000),
                                         superquadric(0.7, 2000, 3300), superquadric(1, 910, 520),
                                         superquadric(2, 0, 0), superquadric(4, 0, 0),
                                         superquadric(40, 390, 0), superquadric(200, 3200, 530000)),
                         test_name);

// Seen along the x axis, so that the middle ray meets a corner and two columns run along edges.
HardCase along_the_axis(const std::string& name, const std::string& formula, double sign,
                        double taylor) {
    return {name,
            fmt::format(R"(
[surface]
formula = "{}"
bounds = {{ sphere = 1.8 }}
[camera]
position = [5, 0, 0]
target = [0, 0, 0]
up = [0, 0, 1]
[isolation]
step = 0.02
[output]
size = [97, 97]
)",
                        formula),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}}};
}

// Distances to thin rods and to balls, the least of which changes along a ray. Their bends are far
// sharper than steps are long.
HardCase distances(const std::string& name, const std::string& key, int count, const char* radius,
                   const char* isolation, const char* angle = "") {
    return {name,
            fmt::format(R"toml(
[surface]
formula = "least(p, {} - R)"
bounds = {{ sphere = 1.5 }}
[arrays.p]
count = {}
cx = "-1 + 2*random(i, 1)"
cy = "-1 + 2*random(i, 2)"
cz = "-1 + 2*random(i, 3)"
R = "{}"
{}
[camera]
position = [4, 0, 0]
{}
[output]
size = [128, 128]
)toml",
                        key, count, radius, angle, isolation),
            {}};
}

INSTANTIATE_TEST_SUITE_P(
    Distances, NonSmooth,
    testing::Values(distances("thin rods",
                              "sqrt(((x - cx)*cos(a) + (y - cy)*sin(a))^2 + (z - cz)^2)", 20,
                              "0.0006 + 0.0084*random(i, 7)", "", "a = '6.28*random(i, 6)'"),
                    distances("balls", "sqrt((x - cx)^2 + (y - cy)^2 + (z - cz)^2)", 60,
                              "0.02 + 0.1*random(i, 7)", "[isolation]\nbeam = false"),
                    distances("discs", "sqrt((x - cx)^2 + (y - cy)^2 + 30*(z - cz)^2)", 40,
                              "0.04 + 0.1*random(i, 7)", "")),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Corners, NonSmooth,
    testing::Values(
        along_the_axis("octahedron at its corner", "abs(x) + abs(y) + abs(z) - 1", 0, 0),
        along_the_axis("cube at its face", "max(max(abs(x), abs(y)), abs(z)) - 1", 0, 0),
        along_the_axis("cube at its corner",
                       "max(max(abs(x + y + z), abs(x - y)), abs(x + y - 2*z)) - 1", 1400, 380),
        along_the_axis("wedge", "abs(y) - 0.3*(1 - x)", 0, 0),
        along_the_axis("star of square roots", "sqrt(abs(x)) + sqrt(abs(y)) + sqrt(abs(z)) - 1",
                       4400, 16000),
        along_the_axis("acos of a ball", "acos(x^2 + y^2 + z^2) - 1", 200, 3800),
        along_the_axis("sheet of asin", "z - 0.5*asin(2*y)", 200, 440),
        along_the_axis("ball dented by a root", "x^2 + y^2 + z^2 - 1 + 0.5*sqrt(z)", 0, 0),
        along_the_axis("root of a difference", "exp(sqrt(x - y)) - 1.5 - z", 700, 4600)),
    test_name);

HardCase seen_from(const std::string& name, const std::string& formula, double azimuth,
                   double elevation, double zoom) {
    return {name,
            fmt::format(R"(
[surface]
formula = "{}"
bounds = {{ sphere = 1.5 }}
[camera]
azimuth = {}
elevation = {}
zoom = {}
[output]
size = [96, 96]
)",
                        formula, azimuth, elevation, zoom),
            {}};
}

// Angles about an axis, seen near to it, where F turns faster than any step is long.
HardCase about_an_axis(const std::string& name, const std::string& formula, double zoom) {
    return seen_from(fmt::format("{} at zoom {}", name, zoom), formula, 90, 45, zoom);
}

const std::string turning_quotient = "(x^2 - y^2)/(x^2 + y^2) - z",
                  turning_waves = "z - 0.3*sin(6*atan(y/x))",
                  turning_spiral = "z - 0.2*sin(8*atan(y/x) + 9*sqrt(x^2 + y^2))";

INSTANTIATE_TEST_SUITE_P(Angles, NonSmooth,
                         testing::Values(about_an_axis("quotient", turning_quotient, 1),
                                         about_an_axis("quotient", turning_quotient, 50),
                                         about_an_axis("waves", turning_waves, 1),
                                         about_an_axis("waves", turning_waves, 10),
                                         about_an_axis("spiral", turning_spiral, 10)),
                         test_name);

// Arguments of floor and sign that are the number at which it jumps, all over some regions
// (shaders/interval/exact.glsl).
HardCase in_rows(const std::string& name, const std::string& formula) {
    return seen_from(name, formula, 30, 35, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, NonSmooth,
    testing::Values(
        in_rows("bricks", "r = floor(4*y); o = r/2 - floor(r/2); u = 2*x + o; z + 0.1*max(abs(u - "
                          "floor(u) - 0.5), abs(4*y - r - 0.5))"),
        in_rows("staggered dots", "r = floor(2*y + 0.5); u = 2*x - 0.5*(r - 2*floor(r/2)); v = u - "
                                  "floor(u + 0.5); sqrt(v^2 + (2*y - r)^2 + 4*z^2) - 0.4"),
        in_rows("every third step", "r = floor(5*x); z - 0.1*(r - 3*floor(r/3))"),
        in_rows("steps on one side", "z - 0.1*floor(4*x*max(0, y))"),
        in_rows("steps above a plane", "z - 0.08*floor(2*x*max(0, z))"),
        in_rows("steps beside a ramp", "z - 0.1*floor(1 + max(0, z)) + 0.1"),
        in_rows("signs of a ramp that ends", "z - 0.2*sign(y*min(1, max(0, 3*x)))")),
    test_name);

// Bases that are never negative on paper, but may be by rounding, which leaves a power no value.
INSTANTIATE_TEST_SUITE_P(
    PowersOfDifferences, NonSmooth,
    testing::Values(
        along_the_axis("ball beside a plateau", "(1 - min(1, x^2 + y^2 + z^2))^1.5 - 0.3", 0, 0),
        along_the_axis("hole beside a plateau", "0.5 - (1 - min(x^2 + y^2 + z^2, 1))^2.5", 0, 0),
        along_the_axis("ball dented by what one exceeds another",
                       "(max(x, y) - y)^1.5 + x^2 + y^2 + z^2 - 1", 0, 0),
        along_the_axis("cap of a size less its number", "(abs(x) - x)^1.5 + y^2 + z^2 - 0.5", 0, 0),
        along_the_axis("product of differences",
                       "((1 - min(1, x^2 + y^2 + z^2))*(2 - 2*min(1, x^2)))^1.5 - 0.3", 0, 0),
        along_the_axis("logarithm beside a plateau", "log(1 - min(1, x^2 + y^2)) + z", 0, 80000),
        along_the_axis("lattice of powers of waves",
                       "(1 - cos(4*x))^1.5 + (1 + sin(4*y))^1.5 + (1 - cos(4*z))^0.7 - 1", 0, 250)),
    test_name);

} // namespace
} // namespace isomotion::stability
