#include "probe/sight.h"

#include <fmt/format.h>

#include "unit/scene/testing.h"

namespace isomotion::probe {
namespace {

using namespace scene;

class Sighting : public Scenes {
protected:
    Sight of(const std::string& formula, const std::string& bounds = "{ sphere = 1.5 }",
             const std::string& more = "") const {
        const Scene scene = loaded(
            fmt::format("[surface]\nformula = \"{}\"\nbounds = {}\n{}", formula, bounds, more));
        return sight(scene, at_time(scene, 0));
    }
};

TEST_F(Sighting, AFormulaWithoutAZeroIsTold) {
    for (const char* bounds : {"{ sphere = 1.5 }", "{ box = [[-1, -1, -1], [1, 1, 1]] }"}) {
        const Sight empty = of("x^2 + y^2 + z^2 + 0.25", bounds);
        ASSERT_TRUE(empty.values.has_value()) << bounds;
        EXPECT_NEAR(empty.values->lo, 0.25, 1e-6);
        EXPECT_GE(empty.values->hi, 2.5);
        EXPECT_NE(why_nothing_is_seen(empty).find("there is no surface: F is 0.25 to"),
                  std::string::npos);
    }
    // In the user's units, whatever they are.
    EXPECT_NEAR(of("1e20*(x^2 + y^2 + z^2 + 0.25)").values->lo, 0.25e20, 1e14);
    EXPECT_LT(of("-(x^2 + y^2 + z^2 + 0.25)").values->hi, 0);
}

TEST_F(Sighting, AFormulaWithAZeroIsNotSaidToHaveNone) {
    for (const char* formula :
         {"x^2 + y^2 + z^2 - 1", "x^2", "x^2 + y^2 + z^2", "abs(x) - 1e-9", "1/x", "log(x)"}) {
        EXPECT_FALSE(of(formula).values.has_value()) << formula;
    }
}

// By an element alone or by a parameter; what is under the root of a sum has no part in it.
TEST_F(Sighting, AValueByWhichFMayJumpAnywhereIsNamed) {
    const auto told = [&](const std::string& formula, const std::string& values) {
        return of(formula, "{ sphere = 3 }", values).unbounded.value_or("");
    };
    const std::string balls = "sum(p, exp(-((x - cx)^2 + y^2 + z^2)/r^2)) - 0.5";
    const auto of_radii = [](const std::string& radii) {
        return "[arrays.p]\ncount = 3\ncx = 'i - 1'\nr = " + radii;
    };
    using testing::HasSubstr;
    EXPECT_THAT(told(balls, of_radii("[0.5, -0.5, 0]")),
                HasSubstr(":7: arrays.p.r[2] is 0 at t = 0: a divisor is 0 by it, and F has no "
                          "value or may jump at every point"));
    EXPECT_THAT(told(balls, of_radii("'sqrt(i - 1)'")),
                HasSubstr("arrays.p.r[0] is 0 (and 1 more like it) at t = 0: a divisor"));
    EXPECT_EQ(told(balls, of_radii("[0.5, -0.5, 1e-6]")), "");
    EXPECT_THAT(told("least(p, abs(x - cx)/r) - 0.5", of_radii("'2 - i'")),
                HasSubstr("arrays.p.r[2] is 0"));
    EXPECT_THAT(told(balls, of_radii("0")), HasSubstr(":7: arrays.p.r is 0 at t = 0: a divisor"));
    // Within a sum over other elements, which are more.
    EXPECT_THAT(told("sum(p, sum(q, exp(-(x - cx - d)^2))/(sum(q, d) - r)) - 1",
                     of_radii("[9, 6, 3]") + "\n[arrays.q]\ncount = 4\nd = 'i'"),
                HasSubstr("arrays.p.r[1] is 6 at t = 0: a divisor"));
    EXPECT_THAT(told("x^2/m + y^2 - 1", "[parameters]\nm = 't'\n"),
                HasSubstr(":5: parameters.m is 0 at t = 0: a divisor"));
    EXPECT_THAT(told("x + log(k*(y^2 + 1))", "[parameters]\nk = -1\n"),
                HasSubstr("parameters.k is -1 at t = 0: F has no value"));
    for (const char* formula : {"1/x", "log(x)", "x + floor(y)", "sqrt(x)"})
        EXPECT_EQ(told(formula, ""), "") << formula;
}

TEST_F(Sighting, SectionsThatTakeAllAwayAreTold) {
    const auto cut = [&](const std::string& section) {
        return of("x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }", "[[sections]]\n" + section);
    };
    EXPECT_THAT(why_nothing_is_seen(cut("normal = [1, 0, 0]\noffset = -1.2\n")),
                testing::HasSubstr("the sections take all of the solid away"));
    EXPECT_FALSE(cut("normal = [1, 0, 0]\noffset = -0.5\n").is_cut_away);
    // An eye in what is cut off stands in no solid.
    const std::string eye = "[camera]\nposition = [0.5, 0, 0]\n";
    EXPECT_TRUE(cut("sphere = 0.1\n" + eye).eye_in_solid);
    EXPECT_FALSE(cut("normal = [1, 0, 0]\n" + eye).eye_in_solid);
}

TEST_F(Sighting, AClosedSurfaceThatIsCutIsASlip) {
    const Sight cut = of("x^2 + y^2 + (z - 1)^2 - 0.7", "{ sphere = 1.5 }");
    EXPECT_GT(cut.cut, 0.01);
    EXPECT_EQ(cut.closed_by, 1.25);
    ASSERT_EQ(slips(cut).size(), 1u);
    EXPECT_NE(slips(cut)[0].find("1.25 times as large"), std::string::npos);
    // The other side is to be seen.
    EXPECT_TRUE(slips(of("x^2 + y^2 + (z - 1)^2 - 0.7", "{ sphere = 1.5 }",
                         "[material]\nback_color = [1, 0, 0]\n"))
                    .empty());
}

TEST_F(Sighting, CoordinatesFarFromTheOriginAreASlip) {
    const auto at = [&](double x) {
        // Written so, F loses its digits wherever coordinates are counted from.
        return slips(of(fmt::format("x^2 - 2*{0}*x + y^2 + 2*{0}*y + z^2 + 2*{0}^2 - 9", x),
                        fmt::format("{{ sphere = 4, centre = [{0}, -{0}, 0] }}", x)));
    };
    ASSERT_EQ(at(500'000).size(), 1u);
    EXPECT_NE(at(500'000)[0].find("translate = [500000, -500000, 0]"), std::string::npos);
    EXPECT_TRUE(at(3000).empty());
    EXPECT_TRUE(slips(of("x^2 + y^2 + z^2 - 9", "{ sphere = 4 }",
                         "[surface.transform]\ntranslate = [500000, 0, 0]\n"))
                    .empty());
}

TEST_F(Sighting, ASurfaceWithoutAnEndIsNoSlip) {
    for (const char* formula : {"z - 0.2*x", "x*y*z - 0.1", "x^2 + y^2 - z^2 - 0.1"}) {
        const Sight endless = of(formula);
        EXPECT_GT(endless.cut, 0) << formula;
        EXPECT_TRUE(slips(endless).empty()) << formula;
    }
    EXPECT_TRUE(slips(of("x^2 + y^2 + z^2 - 1")).empty());
}

TEST_F(Sighting, ACameraInTheSolidIsASlip) {
    const std::string inside = "[camera]\nposition = [0.1, 0, 0.2]\ntarget = [1, 1, 1]\n";
    for (const char* formula : {"x^2 + y^2 + z^2 - 1", "1 - x^2 - y^2 - z^2"}) {
        EXPECT_TRUE(of(formula, "{ sphere = 1.5 }", inside).eye_in_solid) << formula;
        EXPECT_FALSE(of(formula).eye_in_solid) << formula;
    }
    // In a hollow, or without an end to tell the solid by.
    EXPECT_FALSE(of("abs(x^2 + y^2 + z^2 - 1) - 0.2", "{ sphere = 1.5 }", inside).eye_in_solid);
    EXPECT_FALSE(of("z - 3*x", "{ sphere = 1.5 }", inside).eye_in_solid);
}

TEST_F(Sighting, FormulasWithoutANumberAreSaidToHaveNone) {
    EXPECT_NE(why_nothing_is_seen(of("log(x - 5)")).find("no number"), std::string::npos);
}

} // namespace
} // namespace isomotion::probe
