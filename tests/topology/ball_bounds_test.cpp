// Whole timelines of surfaces that reach a ball of bounds: by hand, and against the same solids cut
// out of a box by max().
#include <random>

#include <gtest/gtest.h>

#include "topology/told.h"

namespace isomotion::topology {
namespace {

void expect_in(const std::string& bounds, const std::string& formula, const std::string& parameters,
               const Betti& start, const std::vector<Told>& told, const Betti& end) {
    const Timeline timeline =
        expect_timeline({formula, bounds, parameters, in_a_second}, start, told, end);
    const bool has_kinks = formula.find("max") != formula.npos; // not proved again
    for (const Event& event : timeline.events) EXPECT_TRUE(event.is_proved_again || has_kinks);
}

TEST(BallBounds, TimelinesAreThoseMadeByHand) {
    const Betti ball{1, 0, 0}, ring{1, 1, 0}, nothing{};
    // A half space that fills the ball, seen along axes and across the edges of charts.
    for (const std::string along : {"x", "-z", "(x + y)/sqrt(2)", "(x - y + z)/sqrt(3)"}) {
        expect_in("{ sphere = 1 }", along + " - s", "s = \"4*t - 1.5\"", nothing,
                  {{0.125, Kind::birth}}, ball);
    }
    // A ball that comes from the middle touches the sphere, leaves it, and is gone.
    expect_in("{ sphere = 1 }", "0.25 - (x - s)^2 - y^2 - z^2", "s = \"0.2 + 1.6*t\"", ball,
              {{1.3 / 1.6, Kind::death}}, nothing);
    // A hole through the ball that moves out by its side.
    expect_in("{ sphere = 1 }", "0.16 - (x - s)^2 - y^2", "s = \"0.1 + 1.6*t\"", ring,
              {{0.5 / 1.6, Kind::tunnel_breaks}}, ball);
    // A bubble that comes out of a half space within the bounds, and one of the half space's edge.
    expect_in("{ sphere = 1 }", "max(x - 0.7, 0.09 - (x + s)^2 - y^2 - z^2)", "s = \"1.2*t - 0.1\"",
              {1, 0, 1}, {{0.8 / 1.2, Kind::void_opens}}, ball);
    // The bounds move: they reach two balls, one after the other.
    expect_in("{ sphere = \"R\" }",
              "((x - 1)^2 + y^2 + z^2 - 0.09)*((x + 0.9)^2 + y^2 + z^2 - 0.09)", "R = \"0.5 + t\"",
              nothing, {{0.1, Kind::birth}, {0.2, Kind::birth}}, {2, 0, 0});
    expect_in("{ sphere = 1, centre = [\"c\", 0, 1] }", "x^2 + y^2 + z^2 - 0.25", "c = \"2*t - 1\"",
              ball, {}, ball);
}

// The same solid as the greater of two functions in a box: another search, and other strata.
TEST(BallBounds, AreAWallLikeAnother) {
    int events = 0, complete = 0;
    constexpr unsigned draws = 4;
    for (unsigned seed = 1; seed <= draws; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        std::string formula = "L";
        for (int k = 0; k < 4; ++k) {
            const auto drift = [&](const char* axis) {
                return fmt::format("({} - ({:.4f} + {:.4f}*s))^2", axis, number(random),
                                   0.6 * number(random));
            };
            formula += fmt::format(" - exp(-{:.3f}*({} + {} + {}))", 4 + 2 * number(random),
                                   drift("x"), drift("y"), drift("z"));
        }
        const std::string level =
            fmt::format("s = \"t\"\nL = \"0.45 + {:.3f}*t\"", 0.25 * number(random));
        const double radius = 1 + 0.2 * number(random);
        SCOPED_TRACE(fmt::format("seed {}: {}, {}, radius {}", seed, formula, level, radius));
        const Moving in_ball{formula, fmt::format("{{ sphere = {} }}", radius), level, in_a_second};
        const Moving in_box{fmt::format("max({}, x^2 + y^2 + z^2 - {}^2)", formula, radius),
                            "{ box = [[-1.4, -1.5, -1.3], [1.35, 1.45, 1.55]] }", level,
                            in_a_second};
        const Timeline a = analyse(in_ball.scene()), b = analyse(in_box.scene());
        SCOPED_TRACE(described(a) + "\n" + described(b));
        complete += a.is_complete();
        const std::vector<Event> of_a = that_change(a), of_b = that_change(b);
        if (!a.is_proved || !b.is_proved) continue;
        ASSERT_EQ(of_a.size(), of_b.size());
        for (std::size_t k = 0; k < of_a.size(); ++k) {
            EXPECT_NEAR(middle(of_a[k].time), middle(of_b[k].time), 1e-9);
            EXPECT_EQ(of_a[k].index, of_b[k].index);
            EXPECT_EQ(of_a[k].grows, of_b[k].grows);
            if (of_a[k].kind != Kind::unknown && of_b[k].kind != Kind::unknown) {
                EXPECT_EQ(of_a[k].kind, of_b[k].kind);
            }
            ++events;
        }
        EXPECT_EQ(a.start, b.start);
        EXPECT_EQ(a.end, b.end);
    }
    EXPECT_EQ(complete, int(draws));
    EXPECT_GE(events, 8);
}

} // namespace
} // namespace isomotion::topology
