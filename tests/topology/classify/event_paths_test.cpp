// Sides that are joined: against closed forms, and against what frames say.
#include "topology/classify/event_paths.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/betti/frame_signs.h"
#include "topology/moving_scene.h"
#include "topology/scenes.h"
#include "topology/search/critical.h"

namespace isomotion::topology {
namespace {

scene::Scene moving(const std::string& formula, const std::string& more = "",
                    const std::string& bounds = "{ sphere = 2.6 }") {
    return scene_of(fmt::format("[time]\nfps = 10\nframes = 11\n[surface]\nformula = '{}'\n"
                                "bounds = {}\n{}",
                                formula, bounds, more));
}

struct Found {
    Timeline timeline;
    std::vector<Sides> sides; // of each event
};

Found found(const scene::Scene& scene, formula::Interval range, int effort, int threads = 1) {
    const Side side = solid_side(scene);
    Found found{find_events(scene, side, range), {}};
    const MovingScene frames(scene, side, range);
    PathOptions how;
    how.threads = threads;
    std::vector<std::size_t> which(found.timeline.events.size());
    std::iota(which.begin(), which.end(), std::size_t(0));
    found.sides = frames.proofs(found.timeline.events, how).paths(which, effort);
    return found;
}

// Two balls of a ring meet at x = 1 and, a moment later, at x = -1: through the neck that is then
// as young as that. Paths of double rounding errors' width are not asked for.
TEST(EventPaths, ThroughYoungNecks) {
    for (const double tilt : {1e-3, 1e-6, 1e-9, 1e-11}) {
        SCOPED_TRACE(tilt);
        const scene::Scene scene =
            moving(fmt::format("(x^2 + y^2 - 1)^2/4 + z^2 + 0.05*(x^2 - y^2) - {}*x - c", tilt),
                   "[parameters]\nc = '0.2*t'\n", "{ sphere = 2 }");
        const Found ring = found(scene, {0, 0.5}, 0);
        ASSERT_TRUE(ring.timeline.is_proved);
        ASSERT_EQ(ring.timeline.events.size(), 2u);
        for (const Event& event : ring.timeline.events) EXPECT_EQ(event.index, 1);
        EXPECT_GT(mid(ring.timeline.events[0].where[0]), 0);
        EXPECT_NE(ring.sides[0], Sides::joined);
        EXPECT_EQ(ring.sides[1], Sides::joined);
    }
}

// The same of what isn't solid: a shell closes at the one pole and, a moment later, at the other.
TEST(EventPaths, ThroughYoungHoles) {
    for (const double tilt : {1e-3, 1e-6, 1e-9}) {
        SCOPED_TRACE(tilt);
        const scene::Scene scene =
            moving(fmt::format("(x^2 + y^2 + z^2 - 1)^2/4 + 0.05*z^2 - {}*z - c", tilt),
                   "[parameters]\nc = '0.2*t'\n", "{ sphere = 2 }");
        const Found shell = found(scene, {0.1, 0.5}, 0);
        ASSERT_TRUE(shell.timeline.is_proved);
        ASSERT_EQ(shell.timeline.events.size(), 2u);
        for (const Event& event : shell.timeline.events) EXPECT_EQ(event.index, 2);
        // Through the hole that is left from inside to outside; the last one closes it.
        EXPECT_EQ(shell.sides[0], Sides::joined);
        EXPECT_NE(shell.sides[1], Sides::joined);
    }
}

// Balls in a row that grow: no loop.
TEST(EventPaths, NotInAChain) {
    const scene::Scene scene = moving("sum(balls, exp(-8*((x-cx)^2 + (y-cy)^2 + z^2))) - T",
                                      "[parameters]\nT = '0.9 - 0.75*t'\n[arrays.balls]\ncount = "
                                      "6\ncx = '0.6*i - 1.5 + 0.05*i^2'\ncy = '0.1*(-1)^i'\n");
    for (const int effort : {0, 1, 2}) {
        const Found chain = found(scene, {0, 1}, effort);
        int merges = 0;
        for (std::size_t k = 0; k < chain.sides.size(); ++k) {
            EXPECT_NE(chain.sides[k], Sides::joined);
            merges += chain.timeline.events[k].index == 1;
        }
        EXPECT_EQ(merges, 5);
    }
}

// A ring of balls: the last neck closes it, whichever that is.
TEST(EventPaths, TheLastNeckOfARing) {
    const scene::Scene scene = moving("sum(balls, exp(-8*((x-cx)^2 + (y-cy)^2 + z^2))) - T",
                                      "[parameters]\nT = '0.9 - 0.7*t'\n[arrays.balls]\ncount = "
                                      "9\ncx = '1.25*cos(0.715*i - 0.005*i^1.5)'\n"
                                      "cy = '1.25*sin(0.715*i - 0.005*i^1.5)'\n");
    const Found ring = found(scene, {0, 0.9}, 1);
    std::vector<Sides> necks;
    for (std::size_t k = 0; k < ring.sides.size(); ++k) {
        if (ring.timeline.events[k].index == 1) necks.push_back(ring.sides[k]);
    }
    ASSERT_EQ(necks.size(), 9u);
    EXPECT_EQ(std::ranges::count(necks, Sides::joined), 1);
    EXPECT_EQ(necks.back(), Sides::joined);
}

// Balls that fly together: kinds agree with each other and with the ends, what they say of quiet
// times with grids, and all of it doesn't depend on threads.
TEST(EventPaths, OfCrowds) {
    int by_path = 0, compared = 0;
    for (const int seed : {1, 2, 3}) {
        SCOPED_TRACE(seed);
        const scene::Scene scene = scene_of(
            fmt::format("[time]\nseed = {}\nfps = 10\nframes = 11\n[surface]\n"
                        "formula = 'sum(balls, exp(-8*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.45'\n"
                        "bounds = {{ sphere = 3 }}\n[arrays.balls]\ncount = 11\n"
                        "cx = '(1.1 - 0.5*t)*(2*random(i, 0) - 1)'\n"
                        "cy = '(1.1 - 0.5*t)*(2*random(i, 1) - 1)'\n"
                        "cz = '(1.1 - 0.5*t)*(2*random(i, 2) - 1)'\n",
                        seed));
        AnalyseOptions how;
        how.threads = 1;
        const Timeline timeline = analyse(scene, how);
        EXPECT_TRUE(timeline.is_complete());
        how.threads = 3;
        EXPECT_EQ(analyse(scene, how), timeline);

        by_path += int(std::ranges::count(timeline.events, "path", &Event::kind_proof));
        for (std::size_t k = 1; k < timeline.events.size(); ++k) {
            const Event &before = timeline.events[k - 1], &after = timeline.events[k];
            if (!before.after || after.time.lo - before.time.hi < 0.03) continue;
            ++compared;
            const StillScene frame(scene, before.time.hi / 2 + after.time.lo / 2);
            const SignGrid grid = frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds,
                                              Side::positive, 128);
            EXPECT_EQ(*before.after, betti(grid)) << "event " << k;
        }
    }
    EXPECT_GE(by_path, 3);
    EXPECT_GE(compared, 3);
}

// A motion that swings comes back to its surfaces: what is proved of one holds when it returns.
TEST(EventPaths, OfAMotionThatSwingsAreTheSameOnTheWayBack) {
    const scene::Scene scene =
        moving("(x^2 + y^2 - 1)^2/4 + z^2 + 0.05*(x^2 - y^2) - 0.001*x - c",
               "[parameters]\nc = '0.05 - 0.05*cos(2*pi*t)'\n", "{ sphere = 2 }");
    const Found ring = found(scene, {0, 1}, 0);
    ASSERT_TRUE(ring.timeline.is_proved);
    std::vector<Sides> necks;
    for (std::size_t k = 0; k < ring.sides.size(); ++k) {
        if (ring.timeline.events[k].index == 1) necks.push_back(ring.sides[k]);
    }
    ASSERT_EQ(necks.size(), 4u);
    for (const std::size_t last : {1u, 2u}) EXPECT_EQ(necks[last], Sides::joined);
    for (const std::size_t first : {0u, 3u}) EXPECT_NE(necks[first], Sides::joined);
}

// The rule of a piece of the motion is proved of no time beyond it.
TEST(EventPaths, NotAcrossAKnot) {
    const scene::Scene scene = moving("(x^2 + y^2 - 1)^2/4 + z^2 + 0.05*(x^2 - y^2) - 0.001*x - c",
                                      "[parameters]\nc = '0.2*t'\n", "{ sphere = 2 }");
    const Found ring = found(scene, {0, 0.5}, 0);
    ASSERT_EQ(ring.sides.size(), 2u);
    ASSERT_EQ(ring.sides[1], Sides::joined);
    const std::size_t last = 1;
    const formula::Interval time = ring.timeline.events[last].time;
    for (const auto& range : {formula::Interval{0, time.hi}, formula::Interval{0, mid(time)}}) {
        const MovingScene frames(scene, solid_side(scene), range);
        const auto sides = frames.proofs(ring.timeline.events).paths({&last, 1}, 0);
        EXPECT_EQ(sides[0], range.hi == time.hi ? Sides::joined : Sides::unknown);
    }
}

} // namespace
} // namespace isomotion::topology
