// The timeline of 75 spheres that fall together, 418 events: complete, as a person would claim it
// and as it was kept. Some 20 s of one core.
#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/expectation.h"
#include "topology/golden.h"
#include "topology/scenes.h"
#include "topology/subject.h"
#include "topology/timeline_file.h"

namespace isomotion::topology {
namespace {

TEST(Blobby75, IsCompleteAsClaimedAndAsKept) {
    const scene::Scene scene = animated("blobby75");
    Analysing how;
    how.last = 61;
    Record found{{}, analyse(scene, how)};
    found.subject = subject_of(scene, found.timeline.range);
    const Timeline& timeline = found.timeline;
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_EQ(timeline.events.size(), 418u);
    EXPECT_TRUE(timeline.unresolved.empty());
    EXPECT_EQ(timeline.start, (Betti{75, 0, 0}));
    EXPECT_EQ(timeline.end, (Betti{1, 0, 0}));
    for (const Event& event : timeline.events) {
        EXPECT_TRUE(event.is_proved && event.is_proved_again) << event.time.lo;
        EXPECT_LT(event.time.hi - event.time.lo, 1e-12) << event.time.lo;
    }
    const auto folder = golden_file("long/blobby75").parent_path();
    for (const char* name : {"blobby75.claims.toml", "blobby75.timeline.json"}) {
        const Expectation expectation = read_expectation(folder / name, scene.timeline.fps);
        const Check same = check(expectation, found);
        EXPECT_EQ(same.outcome(), Outcome::passes) << text(same, name);
    }
}

} // namespace
} // namespace isomotion::topology
