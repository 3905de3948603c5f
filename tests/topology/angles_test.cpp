// Polynomials that are written by angles have the events of the polynomials.
#include <gtest/gtest.h>

#include "topology/told.h"

namespace isomotion::topology {
namespace {

struct Written {
    std::string by_angles, polynomial, bounds, parameters;
};

// T_n(a) of all a.
std::string of_angles(int n, const std::string& a) {
    return fmt::format(
        "cos({0}*acos({1}))*cosh({0}*log(max(1, abs({1})) + sqrt(max(1, abs({1}))^2 - 1)))", n, a);
}

Timeline timeline_of(const std::string& formula, const Written& of) {
    return analyse(Moving{formula, of.bounds, of.parameters, in_a_second}.scene());
}

TEST(PolynomialsByAngles, HaveTheEventsOfThePolynomials) {
    const std::string unit = "{ box = [[-1, -1, -1], [1, 1, 1]] }";
    const std::vector<Written> all{
        // Walls are where acos ends.
        {"cos(m*acos(x)) + (m - 4)*y^2 + 0.7*z^2 - c",
         "chebyshev(5, x) + (m - 4)*y^2 + 0.7*z^2 - c", unit, "m = 5\nc = \"0.9 - 2.5*t\""},
        {"cos(4*acos(x*z)) + 2*x + 0.3*y - c", "chebyshev(4, x*z) + 2*x + 0.3*y - c",
         "{ box = [[-1, -1, -0.9], [1, 1, 0.9]] }", "c = \"4*t - 2\""},
        // A wall moves up to 1.
        {"cos(3*acos(x)) + y^2 + z^2 - c", "chebyshev(3, x) + y^2 + z^2 - c",
         "{ box = [[-0.9, -2, -2], [\"t\", 2, 2]] }", "c = \"1.1 - t/2\""},
        {of_angles(3, "x") + " + y^2 + z^2 - c", "chebyshev(3, x) + y^2 + z^2 - c",
         "{ box = [[-1.2, -3, -3], [1.3, 3, 3]] }", "c = \"1.5 - 3*t\""},
        {of_angles(4, "(x + s)") + " + y^2 + z^2 - c", "chebyshev(4, x + s) + y^2 + z^2 - c",
         "{ sphere = 1.1 }", "s = \"0.1*t\"\nc = \"1.1 - t\""}};
    for (const Written& written : all) {
        SCOPED_TRACE(written.by_angles);
        const Timeline expected = timeline_of(written.polynomial, written);
        const Timeline found = timeline_of(written.by_angles, written);
        SCOPED_TRACE(described(found) + "\nof the polynomial:\n" + described(expected));
        EXPECT_TRUE(expected.is_complete());
        EXPECT_TRUE(found.is_complete());
        EXPECT_FALSE(expected.events.empty());
        EXPECT_EQ(found.start, expected.start);
        EXPECT_EQ(found.end, expected.end);
        ASSERT_EQ(found.events.size(), expected.events.size());
        for (std::size_t k = 0; k < found.events.size(); ++k) {
            const Event &a = found.events[k], &b = expected.events[k];
            EXPECT_NEAR(middle(a.time), middle(b.time), 1e-12);
            EXPECT_EQ(a.kind, b.kind);
            EXPECT_EQ(a.stratum, b.stratum);
            EXPECT_TRUE(a.is_proved);
        }
    }
}

// Beyond 1 and -1 acos stays what it is there: those ends are kinks.
TEST(PolynomialsByAngles, EndWhereAcosEnds) {
    const Timeline timeline =
        timeline_of("cos(3*acos(x)) + y^2 + z^2 - c",
                    {{}, {}, "{ box = [[-2, -3, -3], [2, 3, 3]] }", "c = \"0.5 - 2*t\""});
    // There and beyond it is -1 all along a line.
    EXPECT_FALSE(timeline.is_complete()) << described(timeline);
}

// A ring breaks at three places, of which one is on the cut of atan2.
TEST(AnglesOfPoints, HaveEventsOnTheirCut) {
    const std::string ring =
        "(sqrt(x^2 + y^2) - 1)^2 + z^2 + s - 0.002*x - 0.003*y - 0.001*z - 0.06*";
    const std::string bounds = "{ box = [[-1.7, -1.7, -0.9], [1.7, 1.7, 0.9]] }";
    for (const char* angle : {"atan2(y, x)", "2*atan(y/(sqrt(x^2 + y^2) + x))"}) {
        const Timeline found = analyse(Moving{fmt::format("{}cos(3*{})", ring, angle), bounds,
                                              "s = \"0.1*t - 0.1\"", in_a_second}
                                           .scene());
        SCOPED_TRACE(described(found));
        EXPECT_TRUE(found.is_complete());
        EXPECT_EQ(found.start, (Betti{1, 1, 0}));
        EXPECT_EQ(found.end, (Betti{3, 0, 0}));
        EXPECT_EQ(found.events.size(), 3u);
    }
    // A jump that the surface meets is told.
    const Timeline torn = analyse(
        Moving{ring + "0.3*atan2(y, x)", bounds, "s = \"0.1*t - 0.1\"", in_a_second}.scene());
    EXPECT_FALSE(torn.is_complete());
}

// Where one argument is 0, or a part of the other, an angle jumps by half a turn at its axis,
// though its slope along it folds to 0.
TEST(AnglesOfPoints, JumpAtTheirAxis) {
    const std::string ball = "{ sphere = 2 }";
    for (const char* formula :
         {"x^2 + y^2 + z^2 - r - 0.3*cos(atan2(0, x - 0.6))",
          "k = 0; x^2 + y^2 + z^2 - r - 0.3*cos(atan2(k*y, x - 0.6))",
          "x^2 + y^2 + z^2 - r - 0.3*cos(atan2(x - 0.6, x - 0.6) - atan(1))"}) {
        const Timeline found =
            analyse(Moving{formula, ball, "r = \"0.1 + 0.01*t\"", in_a_second}.scene());
        SCOPED_TRACE(std::string(formula) + "\n" + described(found));
        EXPECT_FALSE(found.is_complete());
    }
    const std::string turn = "(t - 0.3)*(0.3005 - t)";
    for (const std::string& angle :
         {"atan2(0, " + turn + ")", "atan2(" + turn + ", " + turn + ") - atan(1)"}) {
        const std::string r = "r = \"0.5 - 0.4*cos(" + angle + ") + 0.01*t\"";
        const Timeline found =
            analyse(Moving{"(x^2 - 0.36)^2 + y^2 + z^2 - 0.3*r", ball, r, in_a_second}.scene());
        SCOPED_TRACE(angle + "\n" + described(found));
        EXPECT_FALSE(found.is_complete());
    }
}

} // namespace
} // namespace isomotion::topology
