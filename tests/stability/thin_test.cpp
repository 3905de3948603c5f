// Things thinner than a step.
#include "stability/hard_case.h"

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

class Thin : public Stability {};

TEST_P(Thin, KeepWithinTheirBounds) { expect_bounds(GetParam()); }

HardCase sheets(double apart, double sign, double taylor) {
    return {fmt::format("sheets {} apart", apart),
            fmt::format(R"toml(
[surface]
formula = "(x - {0})*(x + {0})"
bounds = {{ sphere = 1 }}
[camera]
azimuth = 34
elevation = 23
[isolation]
step = 0.02
)toml",
                        apart / 2),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}}};
}

// A torus of radius 1 whose tube has radius r, seen so near that the tube fills the picture. F is
// of the size r^2 and the difference of two terms of 4: at r = 10^-4 float has lost it all, and a
// finer step finds noise.
HardCase ring(double r, double step, double sign, double taylor, double by_default = 0) {
    return {fmt::format("tube of {}, step {}", r, step),
            fmt::format(R"toml(
[surface]
formula = "(x^2 + y^2 + z^2 + 1 - {0}^2)^2 - 4*(x^2 + y^2)"
bounds = {{ sphere = 1.1 }}
[camera]
position = [3, 1, 2]
target = [1, 0, 0]
projection = "orthographic"
height = {1}
[isolation]
step = {2}
)toml",
                        r, 4 * r, step),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}},
            {},
            by_default};
}

// The same as a distance, whose values are not squares of differences that float has lost.
HardCase round_ring(double r, double step, double sign, double taylor) {
    return {fmt::format("tube of {} by roots, step {}", r, step),
            fmt::format(R"toml(
[surface]
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - {0}^2"
bounds = {{ sphere = 1.1 }}
[camera]
position = [3, 1, 2]
target = [1, 0, 0]
projection = "orthographic"
height = {1}
[isolation]
step = {2}
)toml",
                        r, 4 * r, step),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}}};
}

INSTANTIATE_TEST_SUITE_P(
    Stability, Thin,
    testing::Values(sheets(0.1, 0, 0), sheets(0.01, 0, 0), sheets(0.001, 510000, 0),
                    ring(0.1, 0.02, 0, 390), ring(0.01, 0.02, 5800, 14000, 600),
                    ring(1e-3, 0.02, 630000, 700000, 250000),
                    ring(1e-4, 0.02, 610000, blind, blind), ring(1e-4, 1e-4, 750000, blind, blind),
                    round_ring(1e-4, 0.02, 620000, 560000), round_ring(1e-4, 1e-4, 0, 0)),
    test_name);

} // namespace
} // namespace isomotion::stability
