// Each reason of an incomplete timeline has its advice, and none is given without a reason.
#include "topology/timeline/advice.h"

#include <gmock/gmock.h>

#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::SizeIs;

Timeline with_unresolved(std::vector<const char*> reasons) {
    Timeline timeline = story().timeline;
    for (const char* why : reasons) timeline.unresolved.push_back({{4.9, 5.1}, {}, why, {}, {}});
    return timeline;
}

TEST(Advice, IsNoneForWhatIsComplete) { EXPECT_THAT(advice(story().timeline), IsEmpty()); }

TEST(Advice, IsOneSentenceForEachReason) {
    const std::vector<const char*> reasons{
        unresolved::degenerate,   unresolved::kink,     unresolved::kinks_meet,
        unresolved::on_edge,      unresolved::index,    unresolved::touches_edge,
        unresolved::rule_changes, unresolved::rests,    unresolved::turns,
        unresolved::jumps,        unresolved::no_bounds};
    for (const char* why : reasons)
        EXPECT_THAT(advice(with_unresolved({why, why})), SizeIs(1)) << why;
    // Bounds that are touched at an edge or a point have the same.
    EXPECT_THAT(advice(with_unresolved(reasons)), SizeIs(reasons.size() - 1));
    EXPECT_THAT(advice(with_unresolved({"what no search says"})), IsEmpty());
}

TEST(Advice, SaysWhatToWriteForAKink) {
    EXPECT_THAT(advice(with_unresolved({unresolved::kink})),
                ElementsAre(AllOf(HasSubstr("smoothmin(a, b, k)"), HasSubstr("sqrt(q + k^2)"))));
}

TEST(Advice, IsGivenForKindsAndEnds) {
    Timeline timeline = story().timeline;
    timeline.events[0].kind = Kind::unknown;
    EXPECT_THAT(advice(timeline), ElementsAre(HasSubstr("unknown")));
    timeline = story().timeline;
    timeline.start_is_proved = false;
    EXPECT_THAT(advice(timeline), ElementsAre(HasSubstr("--certify full")));
    timeline.start.reset();
    EXPECT_THAT(advice(timeline), ElementsAre(HasSubstr("another frame")));
    timeline.unresolved.push_back({{0, 0.1}, {}, unresolved::kink, {}, {}});
    EXPECT_THAT(advice(timeline), ElementsAre(HasSubstr("smoothmin"))) << "the cause";
}

} // namespace
} // namespace isomotion::topology
