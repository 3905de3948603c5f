// Events of surfaces whose critical times are known in closed form: all of them and no others.
#include "topology/analyse.h"
#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/moving.h"
#include "topology/search/comoving_fit.h"
#include "topology/timeline/advice.h"

namespace isomotion::topology {
namespace {

const std::string two_gaussians =
    "T - exp(-((x - s)^2 + y^2 + z^2)) - exp(-((x + s)^2 + y^2 + z^2))";

Timeline inside(Timeline timeline) {
    std::erase_if(timeline.events, [](const Event& event) { return event.stratum < 3; });
    return timeline;
}

// Events inside one gyroid cell and a bit: at points where all three products have their extremes.
std::vector<Group> gyroid_inside() {
    const double root = std::sqrt(2);
    return {{0.5, 8, 0, true}, {2 - root, 18, 1, true}, {2 + root, 18, 2, true}, {3.5, 8, 3, true}};
}

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

// Parallel faces that meet do so along a whole face: kinks that are not in general position.
TEST(Events, OfKinksOutOfGeneralPositionAreUnresolvedAndSaySo) {
    const Moving slab{"max(max(abs(x), abs(y)) - 0.7, max(z - 0.3, s - z))",
                      "{ box = [[-2, -2, -2], [2, 2, 2]] }", "s = \"t - 0.35\""};
    const Timeline found = events_of(slab, 0, 0.9, Side::negative, {.smallest = 1e-3});
    EXPECT_FALSE(found.is_proved);
    ASSERT_FALSE(found.unresolved.empty());
    for (const Unresolved& place : found.unresolved) EXPECT_EQ(place.why, unresolved::kinks_meet);
}

TEST(Events, OfADegeneratePointOfASmoothSurfaceSaySo) {
    const Moving smooth{"x^4 + y^2 + z^2 - T", "{ box = [[-2, -2, -2], [2, 2, 2]] }",
                        "T = \"t - 0.5\""};
    const Timeline found = events_of(smooth, 0, 1);
    ASSERT_FALSE(found.unresolved.empty());
    for (const Unresolved& place : found.unresolved) EXPECT_EQ(place.why, unresolved::degenerate);
}

// Reasons that a mathematician accepts: nothing of these is an event at a point.
TEST(Events, OfWhatIsSingularAlongACurveOrAllTheTimeSaySo) {
    const char* const box = "{ box = [[-2.1, -2.2, -2.3], [2.4, 2.5, 2.2]] }";
    const auto expect_reason = [&](const std::string& formula, const std::string& parameters,
                                   const char* why) {
        const Timeline found = events_of({formula, box, parameters}, 0, 1);
        SCOPED_TRACE(described(found));
        EXPECT_FALSE(found.unresolved.empty());
        for (const Unresolved& place : found.unresolved) EXPECT_STREQ(place.why.c_str(), why);
    };
    expect_reason("(x^2 + y^2 - 1)^2 + z^2 - T", "T = \"t - 0.5\"", unresolved::along_curve);
    expect_reason("(x - T)^2 + (y + T)^2 - z^2", "T = \"t - 0.5\"", unresolved::lasting_point);
    // What divides is looked at as kinks are.
    expect_reason("((x - T)^2 + (y + T)^2 - z^2)/(3 - T)", "T = \"t - 0.5\"",
                  unresolved::lasting_point);
}

// Terms that have no bound don't make others negligible.
TEST(Events, OfSumsOfPolesAreThoseOfTheSurface) {
    const Moving poles{"0.5 - sum(b, 0.01/((x - cx)^2 + y^2 + z^2))",
                       "{ box = [[-1.1, -1.2, -1.3], [1.4, 1.5, 1.2]] }", "s = \"0.5 - 0.4*t\"",
                       "[arrays.b]\ncount = 2\nu = [1, -1]\ncx = \"u*s\""};
    // Between them the sum is 0.02/s^2.
    expect_events(events_of(poles, 0, 1), {{0.75, 1, 1, true}});
}

TEST(Events, OfACassiniOfRevolutionIsASplit) {
    const Moving cassini{"(x^2 + y^2 + z^2 + a^2)^2 - 4*a^2*x^2 - b^4", "{ sphere = 3 }",
                         "b = 1\na = \"0.5 + t\""};
    expect_events(events_of(cassini, 0, 1), {{0.5, 1, 1, false}});
}

TEST(Events, OfTheTangleAreAtThreeQuartersOfItsLevels) {
    const std::string formula = "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + c";
    // Turned about two axes, so that it is no sum of functions of one coordinate each.
    const std::string turned = "u = 0.6*x + 0.8*y; s = 0.6*y - 0.8*x; v = 0.8*s + 0.6*z; "
                               "w = 0.8*z - 0.6*s; u^4 - 5*u^2 + v^4 - 5*v^2 + w^4 - 5*w^2 + c";
    for (const std::string& tangle : {formula, turned}) {
        const Moving moving{tangle, "{ box = [[-3.9, -3.8, -3.7], [3.9, 3.8, 3.7]] }",
                            "c = \"20 - 2*t\""};
        expect_events(
            inside(events_of(moving, 0, 11)),
            {{0.625, 8, 0, true}, {3.75, 12, 1, true}, {6.875, 6, 2, true}, {10, 1, 3, true}});
    }
}

TEST(Events, OfTheChmutovOcticAreAtOddLevels) {
    const Moving octic{"chebyshev(8, x) + chebyshev(8, y) + chebyshev(8, z) + c",
                       "{ box = [[-1.04593, -1.04593, -1.04593], [1.04593, 1.04593, 1.04593]] }",
                       "c = \"t - 3.5\""};
    // Four minima and three maxima along each axis.
    expect_events(
        inside(events_of(octic, 0, 7)),
        {{0.5, 27, 3, false}, {2.5, 108, 2, false}, {4.5, 144, 1, false}, {6.5, 64, 0, false}});
}

TEST(Events, OfAGyroidInABoxAreItsOwnAndThoseOfItsFaces) {
    const Moving gyroid{"sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) - c",
                        "{ box = [[-3.6, -3.6, -3.6], [3.6, 3.6, 3.6]] }", "c = \"t - 2\""};
    const Timeline timeline = events_of(gyroid, 0, 4);
    EXPECT_TRUE(timeline.unresolved.empty()) << described(timeline);
    // Inside: saddles at c = -+sqrt(2), extrema at c = -+1.5.
    expect_events(inside(timeline), gyroid_inside());
    // chi of the solid: none before, that of the box after.
    int euler = 0;
    for (const Event& event : timeline.events) {
        if (event.kind == Kind::none) continue;
        euler += (event.index % 2 == 0 ? 1 : -1) * (event.grows ? 1 : -1);
    }
    EXPECT_EQ(euler, 1);
}

TEST(Events, OfASuperquadricAreNone) {
    for (const auto& [from, to] :
         {std::pair(0.3, 0.9), std::pair(0.5, 2.0), std::pair(1.0, 1.0), std::pair(1.2, 4.0),
          std::pair(2.0, 8.0), std::pair(2.0, 40.0)}) {
        const Moving superquadric{"abs(x)^m + abs(y)^m + abs(z)^m - 1",
                                  "{ box = [[-1.05, -1.05, -1.05], [1.05, 1.05, 1.05]] }",
                                  fmt::format("m = \"{} + {}*t\"", from, to - from)};
        expect_events(events_of(superquadric, 0, 1), {});
    }
}

TEST(Events, OfAMonkeySaddleAreUnresolved) {
    // Three sheets meet in one point when the level passes 0: no Morse index.
    const Moving monkey{"x^3 - 3*x*y^2 + z^2 - c", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
                        "c = \"t - 0.5\""};
    const Timeline timeline = events_of(monkey, 0.3, 0.7);
    EXPECT_FALSE(timeline.is_proved);
    EXPECT_FALSE(timeline.is_complete());
    ASSERT_EQ(timeline.unresolved.size(), 1u) << described(timeline);
    const Unresolved& point = timeline.unresolved[0];
    EXPECT_TRUE(contains(point.time, 0.5));
    EXPECT_LT(width(point.time), 1e-4);
    for (const formula::Interval& x : point.where) {
        EXPECT_TRUE(contains(x, 0.0));
        EXPECT_LT(width(x), 1e-3);
    }
    for (const Event& event : timeline.events) EXPECT_LT(event.stratum, 3);
}

TEST(Events, OfATorusThatMeetsItselfAreNotIsolated) {
    // As a polynomial it is singular in two points of the axis from r = R on: a curve in time.
    const Moving torus{"(x^2 + y^2 + z^2 + 1 - r^2)^2 - 4*(x^2 + y^2)", "{ sphere = 3 }",
                       "r = \"0.5 + t\""};
    const Timeline timeline = events_of(torus, 0, 1, Side::negative, {.smallest = 4e-3});
    EXPECT_FALSE(timeline.is_proved);
    EXPECT_FALSE(timeline.unresolved.empty());
    const auto holds = [&](double t, double z) {
        return std::any_of(
            timeline.unresolved.begin(), timeline.unresolved.end(), [&](const Unresolved& place) {
                return contains(place.time, t) && contains(place.where[2], z) &&
                       contains(place.where[0], 0.0) && contains(place.where[1], 0.0);
            });
    };
    EXPECT_TRUE(holds(0.5, 0));
    EXPECT_TRUE(holds(0.75, std::sqrt(1.25 * 1.25 - 1)));
    EXPECT_TRUE(holds(0.9, -std::sqrt(1.4 * 1.4 - 1)));
}

TEST(Events, OfTwoGaussiansThatFlyAreWhereTheyAre) {
    const Moving two{"T - exp(-((x - c - s)^2 + y^2 + z^2)) - exp(-((x - c + s)^2 + y^2 + z^2))",
                     "{ sphere = 6 }", "T = 0.5\nc = \"3*t\"\ns = \"1.5 - t/2\""};
    const MovingField drifts =
        comoving_field(motions(two.scene(), Side::negative, {0, 1}).pieces.at(0), {});
    EXPECT_NE(drifts.x(Box{0.0, 0.0, 0.0, 1.0}, 0), formula::Interval(0.0));
    const Timeline timeline = events_of(two, 0, 1);
    const double t = 2 * (1.5 - std::sqrt(std::log(4)));
    expect_events(timeline, {{t, 1, 1, true}});
    ASSERT_EQ(timeline.events.size(), 1u);
    EXPECT_TRUE(contains(timeline.events[0].where[0], 3 * t));
    EXPECT_LT(width(timeline.events[0].where[0]), 1e-12);
}

// ---- motion

TEST(Events, OfATrackThatSwingsComeBack) {
    // s = 2 - sin^2 passes sqrt(ln 4) on its way there and on its way back.
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = 0.5\ns = \"1.5 + 0.5*cos(2*pi*t)\""};
    const double t = std::acos((std::sqrt(std::log(4)) - 1.5) / 0.5) / (2 * M_PI);
    expect_events(
        events_of(two, 0, 2),
        {{t, 1, 1, true}, {1 - t, 1, 1, false}, {1 + t, 1, 1, true}, {2 - t, 1, 1, false}});
}

TEST(Events, AtATurnOfTheMotionAreUnresolved) {
    const Moving tangle{"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + c",
                        "{ box = [[-2.5, -2.5, -2.5], [2.5, 2.5, 2.5]] }",
                        "c = \"-2 + 2*cos(2*pi*t)\""};
    const Timeline timeline = events_of(tangle, -0.5, 0.5);
    EXPECT_TRUE(inside(timeline).events.empty());
    ASSERT_EQ(timeline.unresolved.size(), 1u);
    EXPECT_TRUE(contains(timeline.unresolved[0].time, 0.0));
}

TEST(Events, OfKeysAreAtTheTimesOfTheirEase) {
    // Between 2 and 4 s from 2 to 1, by each rule.
    const double value = std::sqrt(std::log(4));
    const auto time_where = [&](auto&& rule) {
        double low = 0, high = 1;
        for (int k = 0; k < 60; ++k) {
            const double u = (low + high) / 2;
            (2 - rule(u) > value ? low : high) = u;
        }
        return 2 + 2 * low;
    };
    const std::vector<std::pair<std::string, double>> eases{
        {"linear", time_where([](double u) { return u; })},
        {"smooth", time_where([](double u) { return u * u * (3 - 2 * u); })},
        // Velocities -1/4 at both ends, per second: from its neighbours.
        {"cubic", time_where([](double u) {
             return u * u * (3 - 2 * u) + 0.5 * u * (1 - u) * (1 - u) - 0.5 * u * u * (1 - u);
         })}};
    for (const auto& [ease, time] : eases) {
        SCOPED_TRACE(ease);
        const Moving two{two_gaussians, "{ sphere = 4 }",
                         fmt::format("T = 0.5\ns = {{ keys = [[0, 2], [2, 2], [4, 1], [6, 1]], "
                                     "ease = \"{}\" }}",
                                     ease)};
        expect_events(events_of(two, 0, 6), {{time, 1, 1, true}});
    }
}

TEST(Events, AcrossAJumpAreUnresolved) {
    const Moving two{two_gaussians, "{ sphere = 4 }",
                     "T = 0.5\ns = { keys = [[0, 2], [2, 1]], ease = \"hold\" }"};
    const Timeline timeline = events_of(two, 0, 3);
    EXPECT_FALSE(timeline.is_proved);
    ASSERT_EQ(timeline.unresolved.size(), 1u);
    EXPECT_EQ(timeline.unresolved[0].time, formula::Interval(2.0));
}

TEST(Events, AtAJumpAtTheEndAreUnresolved) {
    // The last frame shows what is after the jump: nothing. And so at one inside, seen from there.
    const Moving ball{"x^2 + y^2 + z^2 - r", "{ sphere = 2 }",
                      "r = { keys = [[0, 1], [1, -1]], ease = \"hold\" }",
                      "[time]\nframes = 11\nfps = 10"};
    const Timeline timeline = analyse(ball.scene(), {});
    EXPECT_FALSE(timeline.is_complete());
    ASSERT_EQ(timeline.unresolved.size(), 1u) << described(timeline);
    EXPECT_EQ(timeline.unresolved[0].time, formula::Interval(1.0));
    EXPECT_EQ(timeline.start, (Betti{1, 0, 0}));
    EXPECT_EQ(timeline.end, (Betti{0, 0, 0}));
    // No jump at an end that only rests from there on.
    const Moving still{"x^2 + y^2 + z^2 - r", "{ sphere = 2 }",
                       "r = { keys = [[0, 1], [1, 1]], ease = \"hold\" }",
                       "[time]\nframes = 11\nfps = 10"};
    EXPECT_TRUE(analyse(still.scene(), {}).is_complete());
}

TEST(Events, AreNotDisturbedByWhatMovesElsewhere) {
    // Cuts of the camera are none of the surface.
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = 0.5\ns = \"2 - t\"",
                     "[camera]\nfov = { keys = [[0, 30], [0.5, 40]], ease = \"hold\" }"};
    expect_events(events_of(two, 0, 1.5), {{2 - std::sqrt(std::log(4)), 1, 1, true}});
}

TEST(Events, OfTheLeastElementAreThoseOfEach) {
    const Moving balls{"least(balls, (x - cx)^2 + y^2 + z^2 + from) - T", "{ sphere = 4 }",
                       "T = \"t/2\"",
                       "[arrays.balls]\ncount = 3\ncx = [-2, 0.25, 2]\nfrom = [0.1, 0.3, 0.2]"};
    expect_events(events_of(balls, 0, 1),
                  {{0.2, 1, 0, true}, {0.4, 1, 0, true}, {0.6, 1, 0, true}});
}

TEST(Events, AtStepsOfTheMotionAreInDoubt) {
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = 0.5\ns = \"2 - floor(t)\""};
    const Timeline timeline = events_of(two, 0, 1.5);
    EXPECT_FALSE(timeline.is_proved);
    EXPECT_FALSE(timeline.doubts.empty());
}

TEST(Events, OfATrackThatRestsHalfwayAreNotLeftToAnother) {
    // In the middle of the range r rests, and all seems to go through c.
    const Moving ball{"(x - c)^2 + y^2 + z^2 - r", "{ sphere = 4 }",
                      "c = \"0.1*t\"\nr = { keys = [[0, 1], [1, -1], [1.5, 1]], ease = "
                      "\"linear\" }"};
    expect_events(events_of(ball, 0, 4), {{0.5, 1, 0, false}, {1.25, 1, 0, true}});
}

TEST(Events, AtStepsBeforeTheMotionRestsAreInDoubt) {
    // In the middle of the range the keys rest, and with them what steps.
    for (const char* step : {"floor(k)", "sign(k - 0.5)", "random(k, 1)", "floor(0.5 + k)*t"}) {
        SCOPED_TRACE(step);
        for (const char* other : {"", " + 0.1*t"}) {
            const Moving ball{"x^2 + y^2 + z^2 - 1 - 0.1*s", "{ sphere = 4 }",
                              fmt::format("s = \"{}{}\"\nk = {{ keys = [[0, 0], [0.5, 1]], "
                                          "ease = \"linear\" }}",
                                          step, other)};
            const Timeline timeline = events_of(ball, 0, 4);
            EXPECT_FALSE(timeline.is_proved);
            EXPECT_FALSE(timeline.doubts.empty());
        }
    }
    // What never moves steps nowhere.
    const Moving ball{"x^2 + y^2 + z^2 - 1 - 0.1*s", "{ sphere = 4 }",
                      "s = \"0.1*t + floor(1.5) + random(3, 1)\""};
    EXPECT_TRUE(events_of(ball, 0, 1).is_proved);
}

TEST(Events, WhereTheBoundsTurnInsideOutAreUnresolved) {
    const auto unresolved = [](const Moving& moving) {
        const Timeline timeline = events_of(moving, 0, 1, Side::negative, {.smallest = 1e-3});
        EXPECT_EQ(timeline.is_proved, timeline.unresolved.empty()) << described(timeline);
        return timeline.unresolved;
    };
    // From 1/4 s to 3/4 s the box is none; the ball is off its walls else.
    const Moving box{"x^2 + y^2 + z^2 - 0.01", "{ box = [[-1, -1, -1], [\"w\", 1, 1]] }",
                     "w = { keys = [[0, 1], [0.5, -3], [1, 1]], ease = \"linear\" }"};
    const auto turned = unresolved(box);
    ASSERT_FALSE(turned.empty());
    const auto holds = [&](double time) {
        return std::ranges::any_of(
            turned, [&](const Unresolved& place) { return contains(place.time, time); });
    };
    for (const double time : {0.25, 0.3, 0.5, 0.6, 0.75}) EXPECT_TRUE(holds(time)) << time;
    EXPECT_FALSE(holds(0.2));
    EXPECT_FALSE(holds(0.8));
    EXPECT_FALSE(
        unresolved({"x^2 + y^2 + z^2 - 0.01", "{ sphere = \"cos(2*pi*t)\" }", ""}).empty());
    EXPECT_TRUE(
        unresolved({"x^2 + y^2 + z^2 - 0.01", "{ sphere = \"2 + cos(2*pi*t)\" }", ""}).empty());
    // A wall that moves less is no matter.
    EXPECT_TRUE(unresolved({"x^2 + y^2 + z^2 - 0.01", "{ box = [[-1, -1, -1], [\"w\", 1, 1]] }",
                            "w = \"1.2 + cos(2*pi*t)\""})
                    .empty());
}

TEST(Events, OfASumOverAnArrayAreThoseOfItsTermsWritten) {
    // 12 pairs far apart, each of which merges when the others do.
    const Moving pairs{"0.5 - sum(blobs, exp(-((x - cx)^2 + (y - cy)^2 + z^2)))",
                       "{ box = [[-5, -20, -4], [5, 140, 4]] }", "s = \"2 - t\"",
                       "[arrays.blobs]\ncount = 24\nside = \"2*(i - 2*floor(i/2)) - 1\"\n"
                       "cx = \"side*s\"\ncy = \"10*floor(i/2)\""};
    const Timeline timeline = events_of(pairs, 0, 1.5);
    ASSERT_EQ(timeline.events.size(), 12u) << described(timeline);
    for (const Event& event : timeline.events) {
        EXPECT_NEAR(middle(event.time), 2 - std::sqrt(std::log(4)), 1e-12);
        EXPECT_EQ(event.index, 1);
        EXPECT_TRUE(event.grows);
    }
    EXPECT_TRUE(timeline.unresolved.empty()) << described(timeline);
}

TEST(Events, OfTwoTracksThatMoveEachByItself) {
    // Searched over the time itself: no track is the clock.
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = \"0.4 + 0.1*t\"\ns = \"2 - t^2\""};
    double low = 0, high = 1;
    for (int k = 0; k < 60; ++k) {
        const double t = (low + high) / 2, s = 2 - t * t;
        (0.4 + 0.1 * t > 2 * std::exp(-s * s) ? low : high) = t;
    }
    expect_events(events_of(two, 0, 1.2), {{low, 1, 1, true}});
}

TEST(Events, OfABallThatRunsAgainstAWallAreOnTheWall) {
    // From the corner of a box that grows: reaches of the ball past the faces x = +-w.
    const Moving ball{"x^2 + y^2 + z^2 - 1", "{ box = [[-2, \"-w\", -2], [2, \"w\", 2]] }",
                      "w = \"1.5 - t\""};
    const Timeline timeline = events_of(ball, 0, 1);
    // A ball becomes a drum: the walls touch it where F falls inwards, and nothing changes.
    EXPECT_TRUE(timeline.is_proved) << described(timeline);
    ASSERT_EQ(timeline.events.size(), 2u) << described(timeline);
    for (const Event& event : timeline.events) {
        EXPECT_EQ(event.stratum, 2);
        EXPECT_EQ(event.kind, Kind::none);
        EXPECT_NEAR(middle(event.time), 0.5, 1e-12);
    }
}

TEST(Events, OfABallThatRunsAgainstASphereAreOnTheSphere) {
    // A ball of radius 1 reaches a sphere of radius 2 when its centre is at 1, and leaves it at 3.
    const Moving ball{"(x - p)^2 + y^2 + z^2 - 1", "{ sphere = 2 }", "p = \"t\""};
    EXPECT_TRUE(events_of(ball, 0, 0.9).events.empty());
    // What is born in a corner of the box around the sphere is outside.
    const Moving corner{"(x - 1.5)^2 + (y - 1.5)^2 + z^2 - s", "{ sphere = 2 }", "s = \"t - 0.1\""};
    EXPECT_TRUE(events_of(corner, 0, 0.11).events.empty());
    const Timeline timeline = events_of(ball, 0, 4);
    EXPECT_TRUE(timeline.is_proved) << described(timeline);
    ASSERT_EQ(timeline.events.size(), 2u) << described(timeline);
    const std::array<Kind, 2> kinds{Kind::none, Kind::death};
    for (std::size_t k = 0; k < 2; ++k) {
        const Event& event = timeline.events[k];
        EXPECT_EQ(event.stratum, 2);
        EXPECT_EQ(event.kind, kinds[k]);
        EXPECT_NEAR(middle(event.time), k == 0 ? 1 : 3, 1e-12);
        EXPECT_NEAR(middle(event.where[0]), 2, 1e-12);
    }
}

// A sphere that is the surface, at one moment: all of it is singular.
TEST(Events, OfASphereThatTheSurfaceCoversAreUnresolved) {
    const Moving ball{"x^2 + y^2 + z^2 - r^2", "{ sphere = 2 }", "r = \"1 + t\""};
    const Timeline timeline = events_of(ball, 0.5, 1.5, Side::negative, {.smallest = 1e-3});
    EXPECT_FALSE(timeline.is_proved);
    ASSERT_FALSE(timeline.unresolved.empty());
    for (const Unresolved& place : timeline.unresolved) EXPECT_TRUE(contains(place.time, 1.0));
}

TEST(Events, DoNotDependOnTheNumberOfThreads) {
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = 0.5\ns = \"2 - t\""};
    const Timeline one = events_of(two, 0, 1.5, Side::negative, {.threads = 1});
    const Timeline three = events_of(two, 0, 1.5, Side::negative, {.threads = 3});
    ASSERT_EQ(one.events.size(), three.events.size());
    for (std::size_t k = 0; k < one.events.size(); ++k) {
        EXPECT_EQ(one.events[k].time, three.events[k].time);
        EXPECT_EQ(one.events[k].where, three.events[k].where);
    }
}

TEST(Events, OfAnInterruptedSearchAreNotAll) {
    const Moving two{two_gaussians, "{ sphere = 4 }", "T = 0.5\ns = \"2 - t\""};
    EventSearchOptions how;
    how.stopped = [] { return true; };
    const Timeline timeline = events_of(two, 0, 1.5, Side::negative, how);
    EXPECT_FALSE(timeline.is_proved);
    EXPECT_FALSE(timeline.doubts.empty());
}

// Half of the box has no value: it is not divided into ever smaller boxes.
TEST(Events, AreNotSoughtWhereTheFormulaHasNoValue) {
    const Moving half{"x^2 + y^2 + z^2 - 0.5 + c*log(x)", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
                      "c = \"0*t\""};
    SearchCost cost;
    const Timeline timeline = find_events(half.scene(), Side::negative, {0, 1}, {}, &cost);
    EXPECT_LT(cost.boxes, 2'000'000) << described(timeline);
    EXPECT_FALSE(timeline.is_proved); // next to x = 0
    for (const Unresolved& place : timeline.unresolved) EXPECT_GT(place.where[0].hi, -0.1);
}

} // namespace
} // namespace isomotion::topology
