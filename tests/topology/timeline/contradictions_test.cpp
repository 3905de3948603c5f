// What a timeline says of itself twice must be the same.
#include "topology/timeline/contradictions.h"

#include <gmock/gmock.h>

#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr animation::FrameRate fps{10, 1};

TEST(Contradictions, OfWhatIsTrueAreNone) {
    EXPECT_THAT(contradictions(story().timeline, fps), IsEmpty());
    Timeline bare = story().timeline;
    for (Event& event : bare.events) event.before = event.after = std::nullopt;
    EXPECT_THAT(contradictions(bare, fps), IsEmpty());
}

TEST(Contradictions, AnEndThatDoesNotFollow) {
    Timeline wrong = story().timeline;
    wrong.end = Betti{2, 0, 0};
    EXPECT_THAT(contradictions(wrong, fps), ElementsAre(HasSubstr("at the end are 2 components")));
}

TEST(Contradictions, OfOneEvent) {
    Timeline wrong = story().timeline;
    wrong.events[0].stratum = 0;
    EXPECT_THAT(contradictions(wrong, fps), ElementsAre(HasSubstr("at most 0 coordinates are")));
    wrong = story().timeline;
    wrong.events[0].grows = false;
    EXPECT_THAT(contradictions(wrong, fps), ElementsAre(HasSubstr("is no merge")));
    wrong = story().timeline;
    wrong.events[0].time = {-2, -1};
    EXPECT_THAT(contradictions(wrong, fps), ElementsAre(HasSubstr("outside of the timeline's")));
}

} // namespace
} // namespace isomotion::topology
