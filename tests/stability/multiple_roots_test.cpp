// Surfaces whose equation has roots of even order: F touches zero and keeps its sign.
#include "stability/hard_case.h"

namespace isomotion::stability {
namespace {

using scene::Method;

class MultipleRoots : public Stability {};

TEST_P(MultipleRoots, KeepWithinTheirBounds) { expect_bounds(GetParam()); }

// Lines of double points, and of isolated ones, among simple roots.
INSTANTIATE_TEST_SUITE_P(
    Surfaces, MultipleRoots,
    testing::Values(
        HardCase{
            "Steiner", surface("steiner"), {{Method::amp_sign, 1100}, {Method::amp_taylor, 910}}},
        HardCase{"cross-cap",
                 surface("cross_cap"),
                 {{Method::amp_sign, 390}, {Method::amp_taylor, 390}}},
        HardCase{"miter", surface("miter"), {{Method::amp_sign, 0}, {Method::amp_taylor, 520}}},
        HardCase{"kiss", surface("kiss"), {{Method::amp_sign, 0}, {Method::amp_taylor, 0}}},
        HardCase{"high silhouette",
                 surface("high_silhouette"),
                 {{Method::amp_sign, 0}, {Method::amp_taylor, 0}}},
        HardCase{
            "nonisol", surface("nonisol"), {{Method::amp_sign, 1600}, {Method::amp_taylor, 0}}}),
    test_name);

// G^2 = 0 has the points of G = 0, all of them double.
struct Factor {
    std::string name, formula, bounds;
};

std::string scene_of_power(const Factor& factor, int power) {
    return "[surface]\nformula = \"(" + factor.formula + ")^" + std::to_string(power) +
           "\"\nbounds = " + factor.bounds + "\n[isolation]\nstep = 0.02\n";
}

HardCase squared(const Factor& factor) {
    // One pixel of 9,216 may show the second of two double roots at a silhouette.
    return {factor.name + " squared",
            scene_of_power(factor, 2),
            {},
            scene_of_power(factor, 1),
            /*by_default=*/110};
}

class SquaredFactor : public testing::TestWithParam<Factor> {};

TEST_P(SquaredFactor, IsMissedBySignsAndFoundByTaylor) {
    const HardCase square = squared(GetParam());
    expect_bounds(square); // by default
    for (const Method signs : {Method::marching, Method::amp_sign}) {
        const Looked looked = look(square, signs);
        ASSERT_GT(looked.certain_hits, 1000);
        // Nothing is negative, so only a sample that is 0 to the last bit could be met.
        EXPECT_GT(looked.errors.missed, looked.certain_hits * 99 / 100);
        EXPECT_EQ(looked.errors.false_hits, 0);
    }
    const Looked taylor = look(square, Method::amp_taylor);
    EXPECT_LE(taylor.errors.missed, 0) << "of " << taylor.certain_hits;
    EXPECT_EQ(taylor.errors.nan, 0);
    EXPECT_EQ(taylor.crooked, 0);
    // An odd power has its sign change back.
    HardCase cubed = square;
    cubed.name = GetParam().name + " cubed";
    cubed.scene = scene_of_power(GetParam(), 3);
    expect_bounds(cubed);
    EXPECT_EQ(look(cubed, Method::amp_sign).errors.missed, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Stability, SquaredFactor,
    testing::Values(
        Factor{"sphere", "x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }"},
        Factor{"torus", "(x^2 + y^2 + z^2 + 0.75)^2 - 4*(x^2 + y^2)", "{ sphere = 1.7 }"},
        Factor{"tangle", "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", "{ sphere = 3.2 }"}),
    [](const auto& tested) { return tested.param.name; });

} // namespace
} // namespace isomotion::stability
