// Timelines of 75 and of 150 spheres that fall together: complete, as a person would claim them;
// the first as it was kept, too. Some 15 s and 50 s of one core.
#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/golden.h"
#include "topology/scenes.h"
#include "topology/timeline/expectation.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {
namespace {

std::filesystem::path beside(const std::string& file) {
    return golden_file("spheres/any").parent_path() / file;
}

TimelineRecord analysed(const scene::Scene& scene) {
    AnalyseOptions how;
    how.last = 61;
    TimelineRecord found{{}, analyse(scene, how)};
    found.header = header_of(scene, found.timeline.range);
    return found;
}

void expect(const TimelineRecord& found, const scene::Scene& scene, const std::string& file) {
    const Expectation expectation = read_expectation(beside(file), scene.timeline.fps);
    const Check same = check(expectation, found);
    EXPECT_EQ(same.outcome(), Outcome::passes) << text(same, file);
}

void expect_proved(const Timeline& timeline) {
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_TRUE(timeline.unresolved.empty());
    EXPECT_EQ(timeline.end, (Betti{1, 0, 0}));
    for (const Event& event : timeline.events) {
        EXPECT_TRUE(event.is_proved && event.is_proved_again) << event.time.lo;
        EXPECT_LT(event.time.hi - event.time.lo, 1e-12) << event.time.lo;
    }
}

TEST(Spheres, SeventyFiveAreAsClaimedAndAsKept) {
    const scene::Scene scene = animated("blobby75");
    const TimelineRecord found = analysed(scene);
    expect_proved(found.timeline);
    EXPECT_EQ(found.timeline.start, (Betti{75, 0, 0}));
    EXPECT_EQ(found.timeline.events.size(), 418u);
    expect(found, scene, "blobby75.claims.toml");
    expect(found, scene, "blobby75.timeline.json");
}

TEST(Spheres, SeedsFindNearlyAllOfSeventyFives) {
    const scene::Scene scene = animated("blobby75");
    AnalyseOptions how;
    how.last = 61;
    how.certify = Certify::fast;
    const Timeline seeded = analyse(scene, how);
    const Timeline kept = read_timeline(beside("blobby75.timeline.json")).timeline;
    EXPECT_FALSE(seeded.is_proved);
    EXPECT_GE(seeded.events.size(), 400u);
    for (const Event& event : seeded.events) {
        EXPECT_TRUE(std::ranges::any_of(kept.events, [&](const Event& other) {
            return !is_empty(intersect(event.time, other.time)) && event.index == other.index;
        })) << event.time.lo;
    }
}

// Where valleys bend, the ways down from points between two minima end in one of them.
TEST(Spheres, AHundredAndFiftyAreAsClaimed) {
    const scene::Scene scene = scene::load(beside("blobby150.toml"));
    const TimelineRecord found = analysed(scene);
    expect_proved(found.timeline);
    EXPECT_EQ(found.timeline.start, (Betti{150, 0, 0}));
    EXPECT_EQ(found.timeline.events.size(), 851u);
    expect(found, scene, "blobby150.claims.toml");
}

} // namespace
} // namespace isomotion::topology
