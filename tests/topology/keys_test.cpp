// Events at keys of a motion, where one rule ends and the next begins.
#include <cmath>

#include <gtest/gtest.h>

#include "thorough.h"
#include "topology/analyse.h"
#include "topology/chance.h"
#include "topology/scenes.h"

namespace isomotion::topology {
namespace {

// A track that falls to a key's value, and on.
struct Fall {
    double first, key, last;
    double at = 1; // the time of the key, in seconds; the last one is at 2
    std::string ease = "linear";
};

// A ball dies and another one is born at the moment at which v falls through a level, which lies
// next to a key's value. `through_time` adds a motion by time, so that v is no clock.
scene::Scene two_balls(const Fall& fall, double level, bool through_time) {
    const std::string v = fmt::format("(v{} - {:.17g})", through_time ? " + w - w" : "", level);
    return scene_of(fmt::format(
        "[time]\nfps = 30\nframes = 61\n[parameters]\n"
        "v = {{ keys = [[0.1, {:.17g}], [{:.17g}, {:.17g}], [2, {:.17g}]], ease = \"{}\" "
        "}}\n{}\n"
        "[surface]\n"
        "formula = \"min((x + 2)^2 + y^2 + z^2 - {}/{:.17g}, (x - 2)^2 + y^2 + z^2 + {})\"\n"
        "bounds = {{ box = [[-4, -4, -4], [4, 4, 4]] }}\n",
        fall.first, fall.at, fall.key, fall.last, fall.ease, through_time ? "w = \"0.001*t\"" : "",
        v, fall.first, v));
}

Timeline timeline_of(const scene::Scene& scene) {
    AnalyseOptions how;
    how.solids[0] = Side::negative;
    return analyse(scene, how);
}

// The difference of the first two keys is rounded, and the level lies in the gap that this leaves.
TEST(Keys, LeaveNoGapBetweenRules) {
    const scene::Scene scene = two_balls({133.67, 0.3, -0.2}, 0.3000000000000057, false);
    const Timeline timeline = timeline_of(scene);
    ASSERT_EQ(timeline.events.size(), 2u);
    EXPECT_NE(timeline.events[0].kind, timeline.events[1].kind);
    for (const Event& event : timeline.events) {
        EXPECT_TRUE(event.kind == Kind::birth || event.kind == Kind::death);
        EXPECT_NEAR(mid(event.time), 1, 1e-12);
    }
}

TEST(Keys, AreNotSteppedOver) {
    Chance chance(7);
    int complete = 0;
    for (int k = 0; k < trials(24, 200); ++k) {
        Fall fall{std::pow(10, chance.number(1, 9)), chance.number(0.1, 0.9), 0};
        fall.last = fall.key - chance.number(0.2, 2);
        if (k % 3 > 0) fall.at = chance.number(0.5, 1.5);
        fall.ease = k % 4 == 3 ? "smooth" : "linear";
        // What the first rule comes to if its way is rounded.
        const double end = fall.first + (fall.key - fall.first);
        const double level = fall.key + chance.number(0, 1) * (end - fall.key);
        SCOPED_TRACE(fmt::format("{:.17g}, at {:.17g} s {:.17g}, {:.17g}, {}; level {:.17g}",
                                 fall.first, fall.at, fall.key, fall.last, fall.ease, level));
        const Timeline timeline = timeline_of(two_balls(fall, level, k % 2 == 1));
        if (!timeline.is_complete()) continue;
        ++complete;
        EXPECT_EQ(timeline.events.size(), 2u);
    }
    EXPECT_GT(complete, 0);
}

// A radius that jumps for a tenth of a second: between its keys there are few doubles, or there are
// few of the coordinates, so that boxes can't be halved any more. Two bodies merge and part.
TEST(Keys, CloseTogetherLoseNoEvent) {
    const auto timeline = [](const std::string& formula, double gap, double centre) {
        const std::string text = fmt::format(
            "[time]\nfps = 30\nframes = 16\n[parameters]\ns = \"0.001*t\"\n"
            "r = {{ keys = [[0, 1], [0.3, 1], [{:.17g}, 1.5], [0.4, 1.5], [{:.17g}, 1], [3, 1]], "
            "ease = \"linear\" }}\n[surface]\nformula = \"u = x - {:.17g}; {}\"\n"
            "bounds = {{ box = [[{:.17g}, -3.2, -3.3], [{:.17g}, 3.1, 3.4]] }}\n",
            0.3 + gap, 0.4 + gap, centre, formula, centre - 3.1, centre + 3.2);
        return timeline_of(scene_of(text));
    };
    const std::string kinked = "(abs(z) - 1.2)^2 + u^2 + y^2 + 0.1*y*u - r^2 + s",
                      smooth = "z^2*(z^2 - 2.4) + 1.44 + u^2 + y^2 + 0.1*y*u - r^2 + s";
    int complete = 0;
    for (const std::string& formula : {kinked, smooth}) {
        for (const double centre : {0.0, 1e11}) {
            for (const double gap : {1e-3, 1e-9, 1e-12, 2e-14, 5e-15, 1e-15}) {
                SCOPED_TRACE(fmt::format("{}, gap {}, centre {}", formula, gap, centre));
                const Timeline found = timeline(formula, gap, centre);
                if (!found.is_complete()) continue;
                ++complete;
                EXPECT_EQ(found.events.size(), 2u);
            }
        }
    }
    EXPECT_GT(complete, 0);
}

// An unresolved place at the first frame has an enclosure that begins before it, where no rule
// holds.
TEST(Keys, BeyondTheRangeTellNothing) {
    const Timeline timeline = timeline_of(
        scene_of("[time]\nfps = 30\nframes = 61\n[parameters]\na = \"t\"\nb = \"t^3\"\n[surface]\n"
                 "formula = \"x^2 + y^2 + z^2 + a + b\"\n"
                 "bounds = { box = [[-3, -3, -3], [3, 3, 3]] }\n"));
    EXPECT_FALSE(timeline.start_is_proved && timeline.start == (Betti{1, 0, 0}));
}

} // namespace
} // namespace isomotion::topology
