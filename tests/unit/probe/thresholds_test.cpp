#include "probe/thresholds.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "unit/scene/testing.h"

namespace isomotion::probe {
namespace {

using namespace scene;

class FieldThresholds : public Scenes {
protected:
    static constexpr double step = 0.01;
    Thresholds of(const std::string& formula, const std::string& bounds = "{ sphere = 1.2 }",
                  const std::string& more = "") const {
        // Settings of its own keep load from asking for thresholds: the tests do.
        const Scene scene =
            loaded(fmt::format("[surface]\nformula = \"{}\"\nbounds = {}\n{}\n[isolation]\nnear = "
                               "1\nfar = 1\nhorizon = 1\n",
                               formula, bounds, more));
        return field_thresholds(
            field_slope(*scene.surfaces[0].field, at_time(scene, 0).surfaces[0]) /
                scene.surfaces[0].field->scale,
            step);
    }
    static double slope(const Thresholds& thresholds) { return thresholds.horizon / 0.1; }
};

void expect_near(const Thresholds& a, const Thresholds& b, double tolerance) {
    EXPECT_NEAR(a.near, b.near, tolerance * b.near);
    EXPECT_NEAR(a.far, b.far, tolerance * b.far);
    EXPECT_NEAR(a.horizon, b.horizon, tolerance * b.horizon);
}

const std::string sphere = "x^2 + y^2 + z^2 - 1";

TEST_F(FieldThresholds, ThreeMultiplesOfOneSlope) {
    const Thresholds found = of(sphere);
    EXPECT_DOUBLE_EQ(found.near, 2 * step * slope(found));
    EXPECT_DOUBLE_EQ(found.far, 8 * step * slope(found));
}

TEST_F(FieldThresholds, OfAPlaneAreExact) {
    EXPECT_DOUBLE_EQ(slope(of("x - 0.25")), 1);
    EXPECT_DOUBLE_EQ(slope(of("3*x + 4*z", "{ box = [[-1, -1, -1], [2, 1, 1]] }")), 5);
}

// |grad F| = 2 r, and r is 1 on the surface.
TEST_F(FieldThresholds, OfTheUnitSphereHaveASlopeNearTwo) {
    EXPECT_NEAR(slope(of(sphere)), 2, 0.1);
    EXPECT_NEAR(slope(of(sphere, "{ box = [[-1.05, -1.05, -1.05], [1.05, 1.05, 1.05]] }")), 2, 0.1);
}

// "Near the surface" is an eighth of the bounds: in wide ones it reaches out to steeper places.
TEST_F(FieldThresholds, OfASmallSphereInWideBoundsKeepTheirMagnitude) {
    const double found = slope(of(sphere, "{ sphere = 3 }"));
    EXPECT_GT(found, 2);
    EXPECT_LT(found, 4);
}

// The surface x = 0 has slopes from exp(-6) to exp(6), in the middle 1. Small values are no sign of
// nearness: they are all over the flat side.
TEST_F(FieldThresholds, AreTakenNearTheSurfaceAndNotWhereTheFieldIsSmall) {
    const double found = slope(of("x*exp(6*y)", "{ box = [[-1, -1, -1], [1, 1, 1]] }"));
    EXPECT_GT(found, 0.7);
    EXPECT_LT(found, 1.4);
}

TEST_F(FieldThresholds, GoWithTheField) {
    const Thresholds one = of(sphere);
    for (const double k : {1e-12, 0.3, 7.0, 1e12}) {
        const Thresholds scaled = of(fmt::format("{}*({})", k, sphere));
        expect_near(scaled, {k * one.near, k * one.far, k * one.horizon}, 1e-9);
    }
    expect_near(of("-(" + sphere + ")"), one, 1e-12);
}

TEST_F(FieldThresholds, GoWithTheCoordinates) {
    const Thresholds one = of(sphere);
    const Thresholds large = of("(x/1000)^2 + (y/1000)^2 + (z/1000)^2 - 1", "{ sphere = 1200 }");
    expect_near(large, {one.near / 1000, one.far / 1000, one.horizon / 1000}, 1e-6);
}

TEST_F(FieldThresholds, AreTheSameEveryTime) {
    const Thresholds a = of("sin(5*x)*cos(3*y) + z^3"), b = of("sin(5*x)*cos(3*y) + z^3");
    EXPECT_EQ(a.near, b.near);
    EXPECT_EQ(a.far, b.far);
    EXPECT_EQ(a.horizon, b.horizon);
}

// Between the blobs the field is a constant in floats, and nearly so in doubles.
TEST_F(FieldThresholds, OfBlobsInAWideSpaceAreFiniteAndPositive) {
    for (const char* bounds : {"{ sphere = 1.2 }", "{ sphere = 3 }", "{ sphere = 10 }"}) {
        const Thresholds found = of("sum(blobs, exp(-60*((x-cx)^2 + y^2 + z^2))) - 0.5", bounds,
                                    "[arrays.blobs]\ncount = 75\ncx = \"2*i/n - 1\"");
        for (const double threshold : {found.near, found.far, found.horizon}) {
            EXPECT_TRUE(std::isfinite(threshold)) << bounds;
            EXPECT_GT(threshold, 0) << bounds;
        }
    }
}

TEST_F(FieldThresholds, OfAFieldWithPolesAreFinite) {
    const Thresholds found = of("1/x + log(abs(y)) + sqrt(z)");
    EXPECT_TRUE(std::isfinite(found.far));
    EXPECT_GT(found.near, 0);
}

TEST_F(FieldThresholds, OfAConstantFieldLeaveTheBaseStep) {
    const Thresholds found = of("max(x, 9) - 8");
    EXPECT_EQ(found.near, 0);
    EXPECT_GT(found.far, 1e29); // no value is far
    EXPECT_EQ(found.horizon, 0);
}

TEST_F(FieldThresholds, FillInWhatASceneLeavesOut) {
    const std::string text = "[surface]\nformula = \"" + sphere + "\"\nbounds = { sphere = 1.2 }\n";
    const Isolation all = loaded(text).surfaces[0].isolation;
    EXPECT_DOUBLE_EQ(all.step, 0.012);
    EXPECT_DOUBLE_EQ(all.far, 4 * all.near);

    const Isolation some = loaded(text + "[isolation]\nhorizon = 0.5\n").surfaces[0].isolation;
    EXPECT_EQ(some.horizon, 0.5);
    EXPECT_EQ(some.near, all.near);
    EXPECT_EQ(some.far, all.far);

    // `far` is never nearer than `near`.
    const Isolation wide = loaded(text + "[isolation]\nnear = 3\n").surfaces[0].isolation;
    EXPECT_EQ(wide.near, 3);
    EXPECT_EQ(wide.far, 3);

    const Isolation coarse = loaded(text + "[isolation]\nstep = 0.12\n").surfaces[0].isolation;
    EXPECT_NEAR(coarse.near, 10 * all.near, 1e-9);
}

class FieldScale : public Scenes {
protected:
    std::shared_ptr<const formula::Field> field(const std::string& factor,
                                                const std::string& formula) const {
        return loaded("[surface]\nformula = \"" + factor + "*(" + formula +
                      ")\"\nbounds = { sphere = 1.2 }\n")
            .surfaces[0]
            .field;
    }
};

// Whatever the factor, a power of two: shaders get the same numbers.
TEST_F(FieldScale, MakesScaledFieldsTheSame) {
    for (const std::string& formula : {sphere, std::string("sin(3*x) + y*exp(z)")}) {
        const auto one = field("1", formula);
        EXPECT_EQ(one->scale, 1);
        formula::FieldEvaluator<float> unscaled(*one);
        std::set<float> ratios;
        for (const int k : {-110, -100, -60, -40, 40, 60, 100, 110}) {
            const auto other = field(fmt::format("2^({})", k), formula);
            formula::FieldEvaluator<float> scaled(*other);
            for (const std::array p : {std::array{0.3f, -0.7f, 0.41f}, {0.9f, 0.2f, -0.33f}})
                ratios.insert(scaled.value({}, p) / unscaled.value({}, p));
        }
        ASSERT_EQ(ratios.size(), 1u);
        EXPECT_EQ(std::ldexp(1.0f, std::ilogb(*ratios.begin())), *ratios.begin());
    }
}

TEST_F(FieldScale, LeavesModerateFieldsAlone) {
    for (const char* factor : {"0.001", "1", "-40", "3000"})
        EXPECT_EQ(field(factor, sphere)->scale, 1);
}

// Outside of its surface such a power passes 10^30, where floats are cut off; inside, 1 decides.
// Scaled for the outside, all that is inside became 0.
TEST_F(FieldScale, LeavesSteepPowersAlone) {
    for (const double radius : {1.45, 1.8, 3.0}) {
        const auto steep = loaded(fmt::format("[surface]\nformula = \"(abs(x)^18.9 + "
                                              "abs(y)^18.9)^9.7 + abs(z)^1.8 - 1\"\nbounds = {{ "
                                              "sphere = {} }}\n",
                                              radius))
                               .surfaces[0]
                               .field;
        EXPECT_EQ(steep->scale, 1) << radius;
    }
    const auto small = field("1", "exp(60*x) + exp(60*y) + exp(60*z) - 0.01");
    EXPECT_EQ(small->scale, 1);
}

// The factor and the scale are one number.
TEST_F(FieldScale, FactorsBeyondFloatsAreScaledToo) {
    const float one = formula::FieldEvaluator<float>(*field("1", sphere)).value({}, {0.5f, 0, 0});
    for (const char* factor : {"2^140", "2^200", "2^(-150)", "2^(-200)"}) {
        const auto other = field(factor, sphere);
        const float ratio = formula::FieldEvaluator<float>(*other).value({}, {0.5f, 0, 0}) / one;
        EXPECT_EQ(std::ldexp(1.0f, std::ilogb(ratio)), ratio) << factor;
    }
}

TEST_F(FieldScale, ValuesBeyondFloatsAreAMistake) {
    try {
        field("1", "(x*1e20)^2*(y*1e20)^2*z");
        ADD_FAILURE();
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("surface.formula: comes to values such as"),
                  std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace isomotion::probe
