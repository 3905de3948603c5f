// Motions that rest where the surface is singular: unresolved for as long as they rest, at the cost
// of a moment.
#include "topology/analyse.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

// Two drops that touch in a point while c is 0.
Moving drops(const std::string& parameters, const std::string& place = "x") {
    return {fmt::format("{0}^4 - 2*{0}^2 + y^2 + z^2 + c", place), "{ sphere = 4 }", parameters};
}

// Unresolved from `from` to `to` and at no other time.
void expect_unresolved(const Timeline& timeline, double from, double to) {
    SCOPED_TRACE(described(timeline));
    EXPECT_FALSE(timeline.is_proved);
    ASSERT_FALSE(timeline.unresolved.empty());
    EXPECT_LT(timeline.unresolved.size(), 10u);
    double first = to, last = from;
    for (const Unresolved& place : timeline.unresolved) {
        first = std::min(first, place.time.lo);
        last = std::max(last, place.time.hi);
    }
    EXPECT_NEAR(first, from, 0.05);
    EXPECT_NEAR(last, to, 0.05);
    EXPECT_TRUE(std::ranges::any_of(timeline.unresolved, [&](const Unresolved& place) {
        return contains(place.time, from + 0.06) && contains(place.time, to - 0.06);
    }));
}

TEST(Resting, WhereTheSurfaceIsSingularIsUnresolvedForAsLong) {
    for (const char* c : {"\"min(max(t - 1, -0.5), 0) + 0.5*max(t - 2, 0)\"",
                          "{ keys = [[0, -0.5], [1, 0], [2, 0], [3, 0.5]] }",
                          "{ keys = [[0, -0.5], [1, 0], [2, 0], [3, 0.5]], ease = \"smooth\" }",
                          "\"(max(t - 2, 0) - max(1 - t, 0))*0.5\""}) {
        SCOPED_TRACE(c);
        const Timeline timeline = events_of(drops(fmt::format("c = {}", c)), 0, 3);
        expect_unresolved(timeline, 1, 2);
        EXPECT_EQ(timeline.unresolved[0].why, "the surface rests, or nearly, where it is singular");
    }
}

TEST(Resting, WhileElseMovesIsUnresolvedForAsLong) {
    const Timeline timeline = events_of(
        drops("d = \"0.1*t\"\nc = { keys = [[0, -0.5], [1, 0], [2, 0], [3, 0.5]] }", "(x - d)"), 0,
        3);
    expect_unresolved(timeline, 1, 2);
}

TEST(Resting, AlongACircleIsUnresolvedForAsLong) {
    // A ring that has no thickness while c is 0.
    const Moving ring{"(x^2 + y^2 - 1)^2 + z^2 + c", "{ sphere = 4 }",
                      "c = \"min(max(t - 1, -0.5), 0) - 0.3*max(t - 2, 0)\""};
    expect_unresolved(events_of(ring, 0, 3), 1, 2);
}

Moving with_time(Moving moving) {
    moving.rest = "[time]\nframes = 31\nfps = 10";
    return moving;
}

// Expects one event at the key of t = 1, between the numbers of both ends.
void expect_one_event_at_the_key(const Moving& moving) {
    SCOPED_TRACE(moving.formula + moving.parameters);
    const Timeline timeline = analyse(with_time(moving).scene());
    SCOPED_TRACE(described(timeline));
    EXPECT_TRUE(timeline.is_complete());
    ASSERT_EQ(timeline.events.size(), 1u);
    EXPECT_NEAR(mid(timeline.events[0].time), 1, 1e-6);
    EXPECT_LT(width(timeline.events[0].time), 1e-6);
    EXPECT_NE(timeline.start, timeline.end);
    EXPECT_EQ(timeline.events[0].before, timeline.start);
    EXPECT_EQ(timeline.events[0].after, timeline.end);
}

// Smoothstep comes to rest at each key: dF/dt is 0 at the event, dF/dc is not.
TEST(Resting, ForAMomentOnItsWayIsAnEvent) {
    const Moving passing[] = {
        drops("c = { keys = [[0, -0.5], [1, 0], [3, 0.5]], ease = \"smooth\" }"),
        // A ring whose hole closes as the tube is as thick as it is wide.
        {"x^2 + y^2 + z^2 + 0.5 - 1.5*r - 2*sqrt(x^2 + y^2 + 0.01)", "{ sphere = 6 }",
         "r = { keys = [[0, 0.1], [1, 0.2], [3, 0.5]], ease = \"smooth\" }"},
        // Two balls come to touch.
        {"min((x - d)^2, (x + d)^2) + y^2 + z^2 - 1", "{ box = [[-4, -2, -2], [4, 2, 2]] }",
         "d = { keys = [[0, 1.6], [1, 1], [3, 0.5]], ease = \"smooth\" }"},
    };
    for (const Moving& moving : passing) expect_one_event_at_the_key(moving);
}

// Each track's own keys, which say nothing of the others; the way between keys is the clock then.
TEST(Resting, OfSeveralTogetherForAMomentIsAnEvent) {
    const std::string balls = "min((x - d)^2 + (y - e)^2 + z^2 - 1, x^2 + y^2 + z^2 - 1)",
                      balls_box = "{ box = [[-2, -2, -2], [4, 4, 2]] }";
    const auto keys = [](const char* ease) {
        return fmt::format("d = {{ keys = [[0, 2.25], [1, 1.25], [3, 1]], ease = \"{0}\" }}\n"
                           "e = {{ keys = [[0, 2], [1, 1.5612494995995996], [3, 0.5]], "
                           "ease = \"{0}\" }}",
                           ease);
    };
    const Moving passing[] = {
        drops("c = { keys = [[0, -0.5], [1, 0], [3, 0.5]], ease = \"smooth\" }\n"
              "d = { keys = [[0, 0.3], [1, 0.1], [3, 0.5]], ease = \"smooth\" }",
              "(x - d)"),
        {balls, balls_box, keys("smooth")},
        // A corner of the way, at full speed.
        {balls, balls_box, keys("linear")},
        {balls, balls_box, keys("cubic")},
        // Bounds reach a ball.
        {"(x - d)^2 + y^2 + z^2 - 0.09", "{ sphere = \"R\" }",
         "R = { keys = [[0, 0.5], [1, 0.7], [3, 0.9]], ease = \"smooth\" }\n"
         "d = { keys = [[0, 1.2], [1, 1], [3, 0.8]], ease = \"smooth\" }"},
    };
    for (const Moving& moving : passing) expect_one_event_at_the_key(moving);
}

TEST(Resting, OfSomeWhileOthersGoByTimeIsSolvedInTime) {
    // A quarter of the time is 0.15625 of the way.
    const Moving ball{"(x - d)^2 + y^2 + z^2 + c + 1.375*w", "{ sphere = 4 }",
                      "c = { keys = [[0, -1], [2, 1]], ease = \"smooth\" }\n"
                      "d = { keys = [[0, 0], [2, 1]], ease = \"smooth\" }\nw = \"t\""};
    expect_events(events_of(ball, 0, 2), {{0.5, 1, 0, false}});
}

TEST(Resting, OfSeveralTogetherAndBackIsATouch) {
    for (const char* ease : {"smooth", "linear"}) {
        const std::string keys =
            fmt::format("d = {{ keys = [[0, 2.25], [1, 1.25], [3, 3]], ease = \"{0}\" }}\n"
                        "e = {{ keys = [[0, 2], [1, 1.5612494995995996], [3, 1.75]], "
                        "ease = \"{0}\" }}",
                        ease);
        const Timeline timeline =
            analyse(with_time({"min((x - d)^2 + (y - e)^2 + z^2 - 1, x^2 + y^2 + z^2 - 1)",
                               "{ box = [[-2, -2, -2], [5, 4, 2]] }", keys})
                        .scene());
        SCOPED_TRACE(described(timeline));
        EXPECT_FALSE(timeline.is_complete());
        EXPECT_TRUE(timeline.events.empty());
        ASSERT_FALSE(timeline.unresolved.empty());
        for (const Unresolved& place : timeline.unresolved) {
            EXPECT_NEAR(mid(place.time), 1, 1e-6);
            EXPECT_EQ(place.before, (Betti{2, 0, 0}));
            EXPECT_EQ(place.after, (Betti{2, 0, 0}));
            EXPECT_EQ(place.why, "the motion turns, rests or ends where the surface is singular");
        }
    }
}

// It comes to the critical value and goes back: the same on both sides, and said to be so.
TEST(Resting, ForAMomentAndBackIsATouch) {
    for (const auto& [keys, solid] : {std::pair{"[[0, -0.5], [1, 0], [3, -0.5]]", Betti{1, 0, 0}},
                                      std::pair{"[[0, 0.5], [1, 0], [3, 0.5]]", Betti{2, 0, 0}}}) {
        SCOPED_TRACE(keys);
        const Timeline timeline = analyse(
            with_time(drops(fmt::format("c = {{ keys = {}, ease = \"smooth\" }}", keys))).scene());
        SCOPED_TRACE(described(timeline));
        EXPECT_FALSE(timeline.is_complete());
        EXPECT_TRUE(timeline.events.empty());
        ASSERT_EQ(timeline.unresolved.size(), 1u);
        EXPECT_TRUE(contains(timeline.unresolved[0].time, 1.0));
        EXPECT_EQ(timeline.unresolved[0].before, solid);
        EXPECT_EQ(timeline.unresolved[0].after, solid);
        EXPECT_EQ(timeline.unresolved[0].why,
                  "the motion turns, rests or ends where the surface is singular");
    }
}

TEST(Resting, ToTheEndLeavesTheEndUnknown) {
    const Moving moving = drops("c = \"min(max(t - 1, -0.5), 0)\"");
    Moving three_seconds = moving;
    three_seconds.rest = "[time]\nframes = 31\nfps = 10";
    const Timeline timeline = analyse(three_seconds.scene());
    expect_unresolved(timeline, 1, 3);
    EXPECT_EQ(timeline.start, (Betti{1, 0, 0}));
    EXPECT_FALSE(timeline.end.has_value());
    EXPECT_FALSE(timeline.is_complete());
}

} // namespace
} // namespace isomotion::topology
