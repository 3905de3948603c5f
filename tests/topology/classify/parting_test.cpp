// Sides of saddles by boxes: joined or apart, as closed forms say.
#include "topology/classify/parting.h"

#include <gtest/gtest.h>

#include "topology/field/timed_formula.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

// The sides of each event, in order of time.
std::vector<Sides> sides_of(const Moving& moving, double from, double to) {
    const scene::Scene scene = moving.scene();
    const Timeline timeline = find_events(scene, Side::negative, {from, to});
    const Motions all = motions(scene, Side::negative, {from, to}, Clock::time);
    const TimedFormula piece(all.pieces.at(0));
    std::vector<Sides> sides;
    for (const Event& event : timeline.events) {
        SpaceFormula formula = piece.formula();
        formula.bindings = piece.bindings(event.time);
        const FieldSnapshot snapshot =
            field_snapshot(std::make_shared<FrameField>(formula), piece.bounds(event.time));
        const SublevelSet region(snapshot, event.index == 1);
        const auto starts = both_sides(region, event);
        sides.push_back(starts ? sides_by_boxes(region, event, *starts) : Sides::unknown);
    }
    return sides;
}

TEST(Parting, IsKnownOfTwoBalls) {
    const Moving balls{"T - exp(-4*((x - 1)^2 + y^2 + z^2)) - exp(-4*((x + 1)^2 + y^2 + z^2))",
                       "{ sphere = 3 }", "T = \"0.3 - 0.3*t\""};
    EXPECT_EQ(sides_of(balls, 0, 0.99), (std::vector{Sides::apart}));
}

// The ring's first neck joins two halves, the second one ends of what is one by then.
TEST(Parting, IsNoneOfWhatIsJoined) {
    for (const double tilt : {1e-2, 1e-3}) {
        SCOPED_TRACE(tilt);
        const Moving ring{
            fmt::format("(x^2 + y^2 - 1)^2/4 + z^2 + 0.05*(x^2 - y^2) - {}*x - c", tilt),
            "{ box = [[-2.1, -2, -2.2], [2, 2.1, 2.2]] }", "c = \"0.2*t\""};
        EXPECT_EQ(sides_of(ring, 0, 0.5), (std::vector{Sides::apart, Sides::joined}));
    }
}

// The same of what isn't solid: a shell closes at one pole, then at the other.
TEST(Parting, IsKnownOfShells) {
    const Moving shell{"(x^2 + y^2 + z^2 - 1)^2/4 + 0.05*z^2 - 0.01*z - c", "{ sphere = 2 }",
                       "c = \"0.2*t\""};
    EXPECT_EQ(sides_of(shell, 0.1, 0.5), (std::vector{Sides::joined, Sides::apart}));
}

// A pocket with two mouths: one closes, and the inside still leads out through the other.
TEST(Parting, IsNoneOfMouthsThatOthersJoin) {
    const auto pocket = [](const char* bounds) {
        return Moving{"exp(-6*(x^2 + y^2 + (z + 0.5)^2)) + exp(-6*((x - 0.6)^2 + y^2 + z^2)) - p",
                      bounds, "p = \"0.2 + 0.1*t\""};
    };
    EXPECT_EQ(sides_of(pocket("{ box = [[-1, -1, -1], [1, 1, 1]] }"), 0, 0.5),
              (std::vector{Sides::joined}));
    // Boxes take too many halvings at the sphere to tell: frames do.
    const auto in_ball = sides_of(pocket("{ sphere = 1 }"), 0, 0.5);
    ASSERT_EQ(in_ball.size(), 1u);
    EXPECT_NE(in_ball[0], Sides::apart);
}

// A slab that reaches the walls: above and below are joined beyond these.
TEST(Parting, KnowsWhatIsOutside) {
    const Moving slab{"z^2 - 0.04 + 0.5*exp(-8*(x^2 + y^2)) - c",
                      "{ box = [[-1, -1, -1.1], [1.2, 1.1, 1]] }", "c = \"0.4 + 0.1*t\""};
    EXPECT_EQ(sides_of(slab, 0, 1), (std::vector{Sides::joined}));
}

} // namespace
} // namespace isomotion::topology
