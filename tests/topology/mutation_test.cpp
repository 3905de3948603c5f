// Whatever is made wrong is noticed: a timeline of a scene that was tampered with, of a search that
// is too coarse, or that lost an event, either isn't complete or differs from the right one.
#include <algorithm>

#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/moving_scene.h"
#include "topology/scenes.h"
#include "topology/search/critical.h"
#include "topology/timeline/compare.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr double dt = 1e-9; // as of the command

// Balls that fly to the middle and join.
struct Balls {
    int seed;
    int count = 5;
    double threshold = 0.45;
    double bounds = 2.6;

    scene::Scene scene() const {
        return scene_of(
            fmt::format("[time]\nseed = {}\nfps = 10\nframes = 11\n[surface]\n"
                        "formula = 'sum(balls, exp(-8*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - {}'\n"
                        "bounds = {{ sphere = {} }}\n[arrays.balls]\ncount = {}\n"
                        "cx = '(1.2 - t)*(2*random(i, 0) - 1)'\n"
                        "cy = '(1.2 - t)*(2*random(i, 1) - 1)'\n"
                        "cz = '(1.2 - t)*(2*random(i, 2) - 1)'\n",
                        seed, threshold, bounds, count));
    }
};

TimelineRecord record_of(const Balls& balls) {
    const scene::Scene scene = balls.scene();
    AnalyseOptions how;
    how.threads = 1;
    TimelineRecord record{{}, analyse(scene, how)};
    record.header = header_of(scene, record.timeline.range);
    return record;
}

bool agrees(const TimelineRecord& expected, const TimelineRecord& found) {
    return compare(expected, found, dt).outcome() == Outcome::passes;
}

bool is_noticed(const TimelineRecord& expected, const TimelineRecord& found) {
    return !found.timeline.is_complete() ||
           compare(expected, found, dt).outcome() == Outcome::differs;
}

class Mutations : public testing::TestWithParam<int> {
protected:
    Mutations()
        : balls_{.seed = GetParam()}
        , expected_(record_of(balls_)) {}

    void SetUp() override {
        ASSERT_TRUE(expected_.timeline.is_complete());
        ASSERT_FALSE(expected_.timeline.events.empty());
        ASSERT_TRUE(agrees(expected_, expected_));
    }

    const Balls balls_;
    const TimelineRecord expected_;
};

TEST_P(Mutations, ABallIsDropped) {
    Balls fewer = balls_;
    for (fewer.count = 4; fewer.count > 0; --fewer.count)
        EXPECT_TRUE(is_noticed(expected_, record_of(fewer))) << fewer.count << " balls";
}

TEST_P(Mutations, TheThresholdIsOffByAMillionth) {
    for (double factor : {1 - 1e-6, 1 + 1e-6}) {
        Balls other = balls_;
        other.threshold *= factor;
        const TimelineRecord found = record_of(other);
        EXPECT_TRUE(found.timeline.is_complete());
        EXPECT_EQ(compare(expected_, found, dt).outcome(), Outcome::differs) << factor;
    }
}

// Where bounds cut the solid it is another, or nothing is proved; wider ones don't matter.
TEST_P(Mutations, BoundsAreMoved) {
    for (double bounds : {0.3, 0.6, 0.9}) {
        Balls other = balls_;
        other.bounds = bounds;
        EXPECT_TRUE(is_noticed(expected_, record_of(other))) << bounds;
    }
    for (double bounds : {2.7, 4.0}) {
        Balls other = balls_;
        other.bounds = bounds;
        EXPECT_TRUE(agrees(expected_, record_of(other))) << bounds;
    }
}

// A search that stops at large boxes may say less, but nothing else.
TEST_P(Mutations, TheSmallestBoxIsTooLarge) {
    const scene::Scene scene = balls_.scene();
    const Side side = solid_side(scene);
    const MovingScene frames(scene, side, expected_.timeline.range);
    TimelineRecord expected = expected_;
    for (Event& event : expected.timeline.events) event.is_proved_again = false; // nor is it here
    int incomplete = 0;
    for (double smallest : {0.5, 0.2, 0.1, 0.03, 0.01, 1e-3}) {
        EventSearchOptions coarse;
        coarse.smallest = smallest;
        TimelineRecord found = expected_;
        found.timeline = find_events(scene, side, expected_.timeline.range, coarse);
        found.timeline.start = expected_.timeline.start;
        found.timeline.end = expected_.timeline.end;
        found.timeline.start_is_proved = found.timeline.end_is_proved = true;
        find_kinds(found.timeline, frames.proofs(found.timeline.events));
        if (!found.timeline.is_complete()) {
            ++incomplete;
            EXPECT_NE(compare(expected, found, dt).outcome(), Outcome::passes) << smallest;
        } else {
            EXPECT_TRUE(agrees(expected, found)) << smallest;
        }
    }
    EXPECT_GT(incomplete, 0);
}

// An event lost, of another index or of the other direction: the Euler number tells, whatever the
// kinds.
TEST_P(Mutations, AnEventIsWrong) {
    Timeline bare = expected_.timeline;
    for (Event& event : bare.events) {
        event.before = event.after = std::nullopt;
        if (event.kind_proof == "index") continue;
        event.kind = Kind::unknown;
        event.kind_proof.clear();
    }
    const auto is_complete = [](Timeline timeline) {
        find_kinds(timeline, {});
        return timeline.is_complete();
    };
    for (std::size_t k = 0; k < bare.events.size(); ++k) {
        Timeline lost = bare;
        lost.events.erase(lost.events.begin() + std::ptrdiff_t(k));
        EXPECT_FALSE(is_complete(lost)) << "event " << k;

        Timeline turned = bare;
        turned.events[k].grows = !turned.events[k].grows;
        EXPECT_FALSE(is_complete(turned)) << "event " << k;

        Timeline twice = bare;
        twice.events.insert(twice.events.begin() + std::ptrdiff_t(k), bare.events[k]);
        EXPECT_FALSE(is_complete(twice)) << "event " << k;

        for (int index = 0; index <= 3; ++index) {
            if ((index - bare.events[k].index) % 2 == 0) continue;
            Timeline other = bare;
            other.events[k].index = index;
            other.events[k].kind = Kind::unknown;
            EXPECT_FALSE(is_complete(other)) << "event " << k << ", index " << index;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Balls, Mutations, testing::Values(1, 2, 3),
                         [](const auto& seed) { return fmt::format("Seed{}", seed.param); });

} // namespace
} // namespace isomotion::topology
