// Events of surfaces whose critical times are known in closed form: all of them and no others.
#include "moving.h"

namespace isomotion::topology {
namespace {

const std::string two_gaussians =
    "T - exp(-((x - s)^2 + y^2 + z^2)) - exp(-((x + s)^2 + y^2 + z^2))";

TEST(Events, OfTwoGaussiansIsOneMerge) {
    // Between them the sum is 2 exp(-s^2).
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = 0.5\ns = \"2 - t\""};
    expect_events(events_of(two, 0, 1.5), {{2 - std::sqrt(std::log(4)), 1, 1, true}});
}

TEST(Events, OfAClosingTorusIsATunnelThatCloses) {
    // Smoothed: e keeps the gradient on the axis; the hole closes where r^2 = (R - e)^2.
    const Moving torus{"(sqrt(x^2 + y^2 + e^2) - R)^2 + z^2 - r^2", "{ sphere = 3 }",
                       "e = 0.25\nR = 1\nr = \"0.3 + t/2\""};
    expect_events(events_of(torus, 0, 1.2), {{0.9, 1, 2, true}});
}

TEST(Events, OfACassiniOfRevolutionIsASplit) {
    const Moving cassini{"(x^2 + y^2 + z^2 + a^2)^2 - 4*a^2*x^2 - b^4", "{ sphere = 3 }",
                         "b = 1\na = \"0.5 + t\""};
    expect_events(events_of(cassini, 0, 1), {{0.5, 1, 1, false}});
}

TEST(Events, OfTheTangleAreAtThreeQuartersOfItsLevels) {
    const Moving tangle{"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + c",
                        "{ box = [[-2.5, -2.5, -2.5], [2.5, 2.5, 2.5]] }", "c = \"20 - 2*t\""};
    expect_events(events_of(tangle, 0, 11), {{0.625, 8, 0, true},
                                             {3.75, 12, 1, true},
                                             {6.875, 6, 2, true},
                                             {10, 1, 3, true}});
}

TEST(Events, OfTheChmutovOcticAreAtOddLevels) {
    const Moving octic{"chebyshev(8, x) + chebyshev(8, y) + chebyshev(8, z) + c",
                       "{ box = [[-1.04593, -1.04593, -1.04593], [1.04593, 1.04593, 1.04593]] }",
                       "c = \"t - 3.5\""};
    // Rising, it takes apart what falling makes.
    std::vector<Event> inside;
    const Timeline timeline = events_of(octic, 0, 7);
    EXPECT_TRUE(timeline.unresolved.empty()) << described(timeline);
}

} // namespace
} // namespace isomotion::topology
