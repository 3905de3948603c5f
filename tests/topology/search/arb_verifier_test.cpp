// Events proved again in balls: those of closed forms all are, and none that was tampered with.
#include "topology/moving.h"
#include "topology/search/arb_verifier.h"

namespace isomotion::topology {
namespace {

using Answer = ArbVerifier::Answer;
using formula::Interval;

struct Case {
    std::string name;
    Moving moving;
    Interval range;
};

const std::vector<Case> cases{
    {"Gaussians",
     {"T - exp(-((x - s)^2 + y^2 + z^2)) - exp(-((x + s)^2 + y^2 + z^2))", "{ sphere = 4 }",
      "T = 0.5\ns = \"2 - t\""},
     {0, 1.5}},
    {"Torus",
     {"(sqrt(x^2 + y^2 + e^2) - R)^2 + z^2 - r^2", "{ sphere = 3 }",
      "e = 0.25\nR = 1\nr = \"0.3 + t/2\""},
     {0, 1.2}},
    {"Cassini",
     {"(x^2 + y^2 + z^2 + a^2)^2 - 4*a^2*x^2 - b^4", "{ sphere = 3 }", "b = 1\na = \"0.5 + t\""},
     {0, 1}},
    // There and back: each event of the track is two of time.
    {"Tangle",
     {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + c",
      "{ box = [[-2.5, -2.5, -2.5], [2.5, 2.5, 2.5]] }", "c = \"9.1 - 11*cos(t)\""},
     {0.3, 6}},
    {"Octic",
     {"chebyshev(8, x) + chebyshev(8, y) + chebyshev(8, z) + c",
      "{ box = [[-1.04593, -1.04593, -1.04593], [1.04593, 1.04593, 1.04593]] }", "c = \"t - 3.5\""},
     {0, 7}},
    {"Gyroid",
     {"sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) - c",
      "{ box = [[-3.6, -3.6, -3.6], [3.6, 3.6, 3.6]] }", "c = \"t - 2\""},
     {0, 4}},
    {"Ball",
     {"sin(2*x)*cos(2*y) + sin(2*y)*cos(2*z) + sin(2*z)*cos(2*x) - c",
      "{ sphere = \"1.3 + 0.1*c\", centre = [0.1, \"0.2*c\", -0.3] }", "c = \"t - 2\""},
     {0, 4}},
    // A wall that moves away from what it cuts, and pieces between keys.
    {"Wall",
     {"x^2 + y^2 + z^2 - 1", "{ box = [[-2, -2, \"w\"], [2, 2, 2]] }",
      "w = { keys = [[0, -1.5], [1, -0.5], [2, 1.5]], ease = \"linear\" }"},
     {0.1, 1.9}},
};

class SecondProofs : public testing::TestWithParam<Case> {
protected:
    SecondProofs()
        : scene(GetParam().moving.scene())
        , timeline(find_events(scene, Side::negative, GetParam().range))
        , proof(scene, Side::negative, GetParam().range) {}

    const scene::Scene scene;
    const Timeline timeline;
    const ArbVerifier proof;
};

TEST_P(SecondProofs, HoldOfAllEvents) {
    ASSERT_FALSE(timeline.events.empty());
    for (const Event& event : timeline.events)
        EXPECT_EQ(proof.verify(event), Answer::holds) << testing::PrintToString(event);
}

TEST_P(SecondProofs, FailOfAnotherIndexOrDirection) {
    for (Event event : timeline.events) {
        event.grows = !event.grows;
        EXPECT_EQ(proof.verify(event), Answer::fails);
        event.grows = !event.grows;
        event.index = event.index == 0 ? 1 : event.index - 1;
        EXPECT_EQ(proof.verify(event), Answer::fails);
    }
}

// By its own width to a side nothing is left of what it encloses, however narrow it is.
TEST_P(SecondProofs, FailOfABoxBesideTheEvent) {
    for (const Event& event : timeline.events) {
        for (std::size_t k = 0; k < 4; ++k) {
            Event moved = event;
            Interval& side = k < 3 ? moved.where[k] : moved.time;
            // A coordinate may be known to be exactly 0.
            const double by = std::max({2 * (side.hi - side.lo), 1e-15 * magnitude(side), 1e-30});
            side = side + Interval(by);
            const Answer answer = proof.verify(moved);
            const auto where = [&] {
                return fmt::format("side {} of ", k) + testing::PrintToString(event);
            };
            // Off its wall it is on no stratum at all.
            if (event.stratum < 3) {
                EXPECT_NE(answer, Answer::holds) << where();
            } else {
                EXPECT_EQ(answer, Answer::fails) << where();
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ClosedForms, SecondProofs, testing::ValuesIn(cases),
                         [](const auto& each) { return each.param.name; });

// Around two events, or none: not that there is one.
TEST(ArbVerifier, DoesNotHoldOfABoxAroundTwo) {
    int asked = 0;
    for (const auto& [name, moving, range] : cases) {
        SCOPED_TRACE(name);
        const scene::Scene scene = moving.scene();
        const ArbVerifier proof(scene, Side::negative, range);
        const Timeline timeline = find_events(scene, Side::negative, range);
        for (std::size_t k = 0; k + 1 < timeline.events.size(); ++k) {
            Event both = timeline.events[k];
            const Event& next = timeline.events[k + 1];
            if (both.stratum < 3 || next.stratum < 3) continue; // perhaps on two faces
            both.time = hull(both.time, next.time);
            for (std::size_t i = 0; i < 3; ++i) both.where[i] = hull(both.where[i], next.where[i]);
            EXPECT_NE(proof.verify(both), Answer::holds);
            ++asked;
        }
    }
    EXPECT_GT(asked, 300);
}

// A face's critical point moves with it, and so does what encloses it.
TEST(ArbVerifier, FailsWhereTheWallIsElsewhereAtTheTime) {
    const Case& wall = cases.back();
    const scene::Scene scene = wall.moving.scene();
    const ArbVerifier proof(scene, Side::negative, wall.range);
    const Timeline timeline = find_events(scene, Side::negative, wall.range);
    int on_walls = 0;
    for (Event event : timeline.events) {
        if (event.stratum == 3 || is_point(event.where[2])) continue;
        ++on_walls;
        // Wide in time, so that the wall passes by; it isn't there at the event.
        event.time = {event.time.lo - 1e-3, event.time.hi + 1e-3};
        EXPECT_EQ(proof.verify(event), Answer::holds);
        event.where[2] = event.where[2] + Interval(1e-4);
        EXPECT_EQ(proof.verify(event), Answer::fails);
    }
    EXPECT_GT(on_walls, 0);
}

TEST(ArbVerifier, OfADegeneratePointIsOpen) {
    const Moving monkey{"x^3 - 3*x*y^2 + z^2 - c", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
                        "c = \"t - 0.5\""};
    const ArbVerifier proof(monkey.scene(), Side::negative, {0, 1});
    Event event;
    event.time = {0.5 - 1e-9, 0.5 + 1e-9};
    event.where.fill({-1e-9, 1e-9});
    event.index = 1;
    EXPECT_EQ(proof.verify(event), Answer::open);
}

TEST(ArbVerifier, MakesADoubtOfWhatFails) {
    const Case& tangle = cases[3];
    const scene::Scene scene = tangle.moving.scene();
    const ArbVerifier proof(scene, Side::negative, tangle.range);
    Timeline right = find_events(scene, Side::negative, tangle.range), wrong = right;
    wrong.events[3].grows = !wrong.events[3].grows;
    wrong.events[5].is_proved = false;

    prove_again(right, proof, {.threads = 1});
    EXPECT_TRUE(right.is_proved);
    EXPECT_TRUE(right.doubts.empty());
    for (const Event& event : right.events) EXPECT_TRUE(event.is_proved_again);

    prove_again(wrong, proof, {.threads = 3});
    EXPECT_FALSE(wrong.is_proved);
    EXPECT_EQ(wrong.doubts.size(), 1u);
    EXPECT_FALSE(wrong.events[3].is_proved);
    for (std::size_t k = 0; k < wrong.events.size(); ++k)
        EXPECT_EQ(wrong.events[k].is_proved_again, k != 3 && k != 5) << k;
}

} // namespace
} // namespace isomotion::topology
