// Whole timelines of scenes: search, proved ends, kinds; and frames between events against grids.
#include "topology/moving_scene.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "thorough.h"
#include "topology/analyse.h"
#include "topology/betti/frame_signs.h"
#include "topology/scenes.h"
#include "topology/search/critical.h"
#include "topology/solids.h"

namespace isomotion::topology {
namespace {

Timeline timeline_of(const scene::Scene& scene, formula::Interval range) {
    const Side side = solid_side(scene);
    Timeline timeline = find_events(scene, side, range);
    const MovingScene frames(scene, side, range);
    timeline.start = frames.certify(range.lo).betti;
    timeline.end = frames.certify(range.hi).betti;
    timeline.start_is_proved = timeline.start.has_value();
    timeline.end_is_proved = timeline.end.has_value();
    find_kinds(timeline, frames.proofs(timeline.events));
    return timeline;
}

TEST(MovingFrame, TangleThroughItsCriticalLevels) {
    const Timeline timeline = timeline_of(animated("tangle"), {0.1, 1.9});
    const auto count = [&](Kind kind) {
        return std::ranges::count(timeline.events, kind, &Event::kind);
    };
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_EQ(timeline.start, (Betti{1, 0, 1}));
    EXPECT_EQ(timeline.end, (Betti{8, 0, 0}));
    EXPECT_EQ(count(Kind::void_opens), 1);
    EXPECT_EQ(count(Kind::tunnel_opens), 5);
    EXPECT_EQ(count(Kind::split), 7);
    EXPECT_EQ(count(Kind::tunnel_breaks), 5);
}

// A frame at a time of the timeline is the one that the scene draws, but for the floats.
TEST(MovingFrame, IsTheScenesFrame) {
    const scene::Scene scene = animated("blobby75");
    const MovingScene frames(scene, Side::positive, {0, 4});
    for (double time : {0.3, 1.7, 3.1}) {
        const StillScene drawn(scene, time);
        const MovingScene::Still moving = frames.at(time);
        EXPECT_NEAR(moving.bounds.radius, drawn.bounds.radius, 1e-6);
        FrameField exact(moving.formula), rounded(drawn.formula(Side::positive));
        const SpaceBox point{0.3, -0.4, 0.5};
        formula::Interval a, b;
        exact.values(exact.everything(), {&point, 1}, {&a, 1});
        rounded.values(rounded.everything(), {&point, 1}, {&b, 1});
        EXPECT_NEAR(mid(a), mid(b), 1e-4);
        EXPECT_LT(width(a), 1e-9);
    }
}

// Balls that fly through each other: Betti numbers read off between events are those of grids.
TEST(MovingFrame, BetweenEventsAsGrids) {
    int compared = 0;
    for (int seed : {1, 2, 3}) {
        const scene::Scene scene = scene_of(fmt::format(
            "[time]\nseed = {}\n[surface]\n"
            "formula = 'sum(blobs, exp(-8*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.45'\n"
            "bounds = {{ sphere = 2.6 }}\n[arrays.blobs]\ncount = 5\n"
            "cx = '(1.2 - t)*(2*random(i, 0) - 1)'\ncy = '(1.2 - t)*(2*random(i, 1) - 1)'\n"
            "cz = '(1.2 - t)*(2*random(i, 2) - 1)'\n",
            seed));
        const Timeline timeline = timeline_of(scene, {0, 1});
        EXPECT_TRUE(timeline.doubts.empty()) << "seed " << seed << ": " << timeline.doubts[0];
        EXPECT_TRUE(timeline.is_complete()) << "seed " << seed;
        for (std::size_t k = 1; k < timeline.events.size(); ++k) {
            const Event &before = timeline.events[k - 1], &after = timeline.events[k];
            if (!before.after || after.time.lo - before.time.hi < 0.02) continue;
            ++compared;
            const StillScene frame(scene, mid(formula::Interval(before.time.hi, after.time.lo)));
            const SignGrid grid = frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds,
                                              Side::positive, 128);
            EXPECT_EQ(*before.after, betti(grid)) << "seed " << seed << ", event " << k;
        }
    }
    EXPECT_GE(compared, 3);
}

// A number in place of a name may let the operation vanish that has no value: 0*log(x), x^0.5. The
// ball lies where x < 0, where no picture shows it.
TEST(MovingScene, WhereTheFormulaHasNoValueNothingIsProved) {
    const std::string ball = "(x + 0.6)^2 + y^2 + z^2 - 0.2";
    for (const auto& [formula, c] : {std::pair{" + x^c", "0.5"},
                                     {" + c*log(x)", "0"},
                                     {" + c*x^0.3", "0"},
                                     {" + c/x", "0"},
                                     {" + abs(sign(x/c))", "0"},
                                     {" + x^c", "\"0.5+0*t\""}}) {
        SCOPED_TRACE(formula);
        const scene::Scene scene = scene_of(fmt::format(
            "[time]\nframes = 3\nfps = 10\n[surface]\nformula = \"{}{}\"\nbounds = {{ box = "
            "[[-1.3, -1.3, -1.3], [1.3, 1.3, 1.3]] }}\n[parameters]\nc = {}\n",
            ball, formula, c));
        const Side solid = solid_side(scene);
        const MovingScene moving(scene, solid, {0, 0.2});
        EXPECT_FALSE(moving.certify(0.1, {.depth = 5}).betti);
    }
}

// A track or a bound without a value for some time, which min hides.
TEST(MovingScene, WhileAParameterHasNoValueNothingIsProved) {
    const std::string none = "3 + sin(log((t - 0.1)^2 - 0.0001))";
    std::vector<std::array<std::string, 3>> cases{{"2", "min(t - 0.1, " + none + ")", "t"},
                                                  {"min(2, " + none + ")", "t - 0.12", "0"}};
    if (is_thorough()) cases.push_back({"2", "min(t - 0.1, " + none + ")", "0"});
    for (const auto& [bound, c, more] : cases) {
        SCOPED_TRACE(bound + "; " + c);
        const scene::Scene scene = scene_of(fmt::format(
            "[surface]\nformula = \"x^2 + y^2 + z^2 - c + 0*d\"\nbounds = {{ sphere = \"R\" }}\n"
            "[parameters]\nR = \"{}\"\nc = \"{}\"\nd = \"{}\"\n",
            bound, c, more));
        EXPECT_FALSE(find_events(scene, Side::negative, {0, 0.2}, {.smallest = 1e-4}).is_proved);
    }
}

// The second count of a span asks for its middle, which need be no frame: there the camera stands
// at its target, which no picture could show and no proof asks for.
TEST(MovingScene, ACameraBetweenFramesIsNoMatter) {
    const Timeline timeline = analyse(
        scene_of("[time]\nfps = 10\nframes = 12\n[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\n"
                 "bounds.box = [[-2, -2, -2], [2, 2, 2]]\n"
                 "[camera]\ntarget = [0, 0, 0]\nposition = [\"5.5 - 10*t\", 0, 0]\n"));
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_EQ(timeline.recount, (Recount{1, 1}));
}

// What random() makes of bounds depends on the scene's seed, in the search as in frames.
TEST(MovingScene, HasTheBoundsOfItsSeed) {
    const auto timeline = [](const std::string& bounds) {
        AnalyseOptions how;
        how.solids[0] = Side::negative;
        return analyse(scene_of("[time]\nfps = 30\nframes = 61\nseed = 7\n[parameters]\n"
                                "p = \"0.05*exp(-20*(t - 0.6)^2) - 0.02\"\n[surface]\n"
                                "formula = \"(x - 1.7)^2 + y^2 + z^2 + 0.1*x*y*z - p\"\nbounds = " +
                                bounds + "\n"),
                       how);
    };
    for (const std::string bounds :
         {"{ sphere = \"1 + 1.4*random(27, 1)\" }",
          "{ box = [[-1, -1.3, -1.4], [\"1 + 1.4*random(27, 1)\", 1.5, 1.6]] }"}) {
        SCOPED_TRACE(bounds);
        const Timeline found = timeline(bounds);
        EXPECT_TRUE(found.is_complete());
        EXPECT_EQ(found.events.size(), 2u);
    }
}

} // namespace
} // namespace isomotion::topology
