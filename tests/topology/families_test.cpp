// Motions that nobody chose: whatever is drawn is searched to the end, and each event and its kind
// is proved.
#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/families.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

// Complete, and the numbers between the ends' certified frames follow from the events.
void expect_complete(const FamilyDraw& drawn) {
    SCOPED_TRACE(drawn.name);
    const Timeline timeline = analyse(scene_of(drawn.text));
    SCOPED_TRACE(described(timeline));
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_TRUE(timeline.start_is_proved && timeline.end_is_proved);
    ASSERT_TRUE(timeline.start && timeline.end);
    Betti now = *timeline.start;
    int euler = now.euler();
    for (const Event& event : timeline.events) {
        EXPECT_TRUE(event.is_proved && event.is_proved_again) << event.time.lo;
        EXPECT_NE(event.kind, Kind::unknown) << event.time.lo;
        euler += euler_change(event);
        const Betti add = change(event.kind);
        now = {now.components + add.components, now.tunnels + add.tunnels, now.voids + add.voids};
        EXPECT_EQ(now.euler(), euler) << event.time.lo;
        ASSERT_TRUE(event.after.has_value()) << event.time.lo;
        EXPECT_EQ(*event.after, now) << event.time.lo;
    }
    EXPECT_EQ(now, *timeline.end);
}

TEST(Families, AreCompleteWhateverMoves) {
    for (const unsigned seed : {9u, 34u}) expect_complete(draw_family(seed, 8, 24));
}

class FamiliesOfAnySize : public testing::TestWithParam<unsigned> {};
TEST_P(FamiliesOfAnySize, AreComplete) { expect_complete(draw_family(GetParam(), 20, 150)); }
INSTANTIATE_TEST_SUITE_P(Seeds, FamiliesOfAnySize, testing::Range(1u, 41u));

} // namespace
} // namespace isomotion::topology
