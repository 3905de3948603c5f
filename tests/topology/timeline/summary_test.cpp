// A timeline in a few lines: the good case, and every other.
#include "topology/timeline/summary.h"

#include <gmock/gmock.h>

#include "topology/timeline/words.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::HasSubstr;

TEST(Summary, OfAllThatIsProved) {
    EXPECT_EQ(summary(story()), "A <made> & timed \"scene\": frames 1 to 101, 0 to 10 s\n"
                                "3 -> 1 components, 0 -> 0 tunnels, 0 -> 0 voids\n"
                                "4 events: 2 merges, 1 tunnel forms, 1 tunnel closes; first at "
                                "frame 10.5, last at 90.7\n"
                                "complete, all proved\n");
    EXPECT_THAT(summary(complete({1, 0, 0}, {})), HasSubstr("\nno event\ncomplete, all proved\n"));
    EXPECT_THAT(summary(complete({1, 0, 0}, {event_at(5.125, Kind::birth)})),
                HasSubstr("\n1 event: 1 birth; at frame 5.125\n"));
}

TEST(Summary, TellsHowManyEventsAreProvedAgain) {
    TimelineRecord record = story();
    record.timeline.events[1].is_proved_again = true;
    EXPECT_THAT(summary(record),
                HasSubstr("\n1 of 4 events proved again in ball arithmetic\ncomplete"));
    for (Event& event : record.timeline.events) event.is_proved_again = true;
    EXPECT_THAT(summary(record),
                HasSubstr("\neach event proved again in ball arithmetic\ncomplete"));
}

TEST(Summary, TellsHowManySpansAreCountedAgain) {
    TimelineRecord record = story();
    record.timeline.recount = {5, 5};
    EXPECT_THAT(
        summary(record),
        HasSubstr("\nBetti numbers counted again in 5 of 5 proved spans between events\ncomplete"));
    record.timeline.recount = {5, 3};
    EXPECT_THAT(
        summary(record),
        HasSubstr(
            "\nBetti numbers counted again in 3 of 5 proved spans between events; the others"));
}

TEST(Summary, NeverCallsCompleteWhatIsNot) {
    const auto with = [](auto&& edit) {
        TimelineRecord record = story();
        edit(record.timeline);
        const std::string text = summary(record);
        EXPECT_EQ(text.find("complete, all proved"), text.npos) << text;
        EXPECT_THAT(text, HasSubstr("\nINCOMPLETE\n    "));
        EXPECT_FALSE(gaps(record.timeline, record.header.fps).empty());
        return text;
    };
    EXPECT_THAT(with([](Timeline& t) { t.is_proved = false; }),
                HasSubstr("it is not proved that no event is missing"));
    EXPECT_THAT(with([](Timeline& t) { t.doubts.push_back("interrupted"); }),
                HasSubstr("    interrupted\n"));
    EXPECT_THAT(with([](Timeline& t) { t.events[0].is_proved = false; }),
                HasSubstr("    1 event is not proved\n"));
    EXPECT_THAT(with([](Timeline& t) { t.events[0].kind = t.events[1].kind = Kind::unknown; }),
                HasSubstr("    2 events are of unknown kind\n"));
    EXPECT_THAT(with([](Timeline& t) { t.start_is_proved = false; }),
                HasSubstr("    the topology at the start is not proved\n"));
    EXPECT_THAT(with([](Timeline& t) { t.end.reset(); }),
                HasSubstr("3 -> ? components, 0 -> ? tunnels, 0 -> ? voids\n"));
    EXPECT_THAT(with([](Timeline& t) {
                    t.unresolved.push_back({{4.9, 5.1}, {}, "a degenerate critical point", {}, {}});
                }),
                HasSubstr("    unresolved at frame 50 to 52, near (0, 0, 0): a degenerate"));
}

// gaps() and is_complete() are two ways to say one thing.
TEST(Summary, GapsAreThereExactlyWhenATimelineIsNotComplete) {
    for (unsigned bits = 0; bits < 256; ++bits) {
        Timeline t = story().timeline;
        if (bits & 1) t.is_proved = false;
        if (bits & 2) t.start_is_proved = false;
        if (bits & 4) t.end_is_proved = false;
        if (bits & 8) t.start.reset();
        if (bits & 16) t.doubts.push_back("");
        if (bits & 32) t.unresolved.push_back({});
        if (bits & 64) t.events[1].is_proved = false;
        if (bits & 128) t.events[2].kind = Kind::unknown;
        EXPECT_EQ(gaps(t, {10, 1}).empty(), t.is_complete()) << bits;
    }
}

TEST(Summary, Words) {
    EXPECT_EQ(counted(1, Kind::void_born), "1 void born");
    EXPECT_EQ(counted(2, Kind::void_born), "2 voids born");
    EXPECT_EQ(counted(68, Kind::tunnel_forms), "68 tunnels form");
    EXPECT_EQ(in_words({1, 2, 0}), "1 component, 2 tunnels, 0 voids");
    EXPECT_EQ(frame_text(12.0), "12");
    EXPECT_EQ(frame_text(12.34567), "12.3457");
    EXPECT_EQ(frame_text(formula::Interval{12.3, 12.6}), "12.3 to 12.6");
    EXPECT_EQ(frame_text(near(12.5)), "12.5");
}

} // namespace
} // namespace isomotion::topology
