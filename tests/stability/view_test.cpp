// Cameras that see a plain surface in a way that takes away digits: from inside it, on it, from
// afar, along it, through a needle's eye and a fish's.
#include "stability/hard_case.h"

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

class View : public Stability {};

TEST_P(View, KeepsWithinItsBounds) { expect_bounds(GetParam()); }

HardCase view(const std::string& name, const std::string& formula, const std::string& bounds,
              const std::string& camera, double sign, double taylor) {
    return {name,
            fmt::format("[surface]\nformula = \"{}\"\nbounds = {}\n[camera]\n{}\n[isolation]\n"
                        "step = 0.02\n",
                        formula, bounds, camera),
            {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}}};
}

constexpr const char* sphere = "x^2 + y^2 + z^2 - 1";
constexpr const char* torus = "(x^2 + y^2 + z^2 + 0.75)^2 - 4*(x^2 + y^2)";
constexpr const char* wide = "{ sphere = 1.7 }";

INSTANTIATE_TEST_SUITE_P(
    Stability, View,
    testing::Values(
        view("inside a sphere", sphere, wide, "position = [0, 0, 0]\ntarget = [1, 0.2, 0.1]", 0, 0),
        view("inside a torus", torus, wide, "position = [1, 0, 0]\ntarget = [0.9, 1, 0.1]", 0, 0),
        // The first sample of every ray is 0.
        view("on a sphere, looking in", sphere, wide, "position = [1, 0, 0]\ntarget = [0, 0.2, 0]",
             0, 0),
        view("on a sphere, looking out", sphere, wide, "position = [1, 0, 0]\ntarget = [2, 0.2, 0]",
             0, 0),
        view("on a torus, looking along", torus, wide,
             "position = [1.5, 0, 0]\ntarget = [1.4, 1, 0.2]", 0, 0),
        view("torus, 10^5 away", torus, wide,
             "position = [6e4, 4.8e4, 6.4e4]\ntarget = [0, 0, 0]\nfov = 0.0018", 0, 0),
        view("torus, 10^8 away", torus, wide,
             "position = [6e7, 4.8e7, 6.4e7]\ntarget = [0, 0, 0]\nfov = 1.8e-6", 0, 0),
        view("torus, fov 0.1", torus, wide, "position = [0, 0, 4]\ntarget = [1, 0.3, 0]\nfov = 0.1",
             0, 0),
        view("torus, fov 170", torus, wide,
             "position = [0.2, 0.1, 0.6]\ntarget = [1, 0.3, 0]\nfov = 170", 0, 0),
        // From the horizon down to a slope of 10^-3 (10^-5), where the plane is a step deep in z.
        view("plane, grazed at 10^-3", "z", "{ box = [[-1, -1, -0.1], [1, 1, 0.1]] }",
             "position = [1.5, 0, 0.0005]\ntarget = [0, 0, 0]\nup = [0, 0, 1]\nfov = 0.06", 0, 0),
        view("plane, grazed at 10^-5", "z", "{ box = [[-1, -1, -0.1], [1, 1, 0.1]] }",
             "position = [1.5, 0, 0.000005]\ntarget = [0, 0, 0]\nup = [0, 0, 1]\nfov = 0.0006", 0,
             0),
        view("sphere at its limb", sphere, wide,
             "position = [5, 1, 0]\ntarget = [0, 1, 0]\nfov = 1", 0, 0)),
    test_name);

} // namespace
} // namespace isomotion::stability
