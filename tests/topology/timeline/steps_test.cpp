// Betti numbers between events, as far as a timeline says them.
#include "topology/timeline/steps.h"

#include <gmock/gmock.h>

#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

TEST(Steps, FollowFromTheStartAndLastFromEventToEvent) {
    const TimelineRecord record = story();
    const Steps all = steps_of(record.timeline);
    ASSERT_EQ(all.steps.size(), 5u);
    const Betti expected[] = {{3, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}};
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_EQ(all.steps[k].solid, expected[k]) << k;
        EXPECT_TRUE(all.steps[k].is_proved) << k;
    }
    EXPECT_EQ(all.at(0), &all.steps[0]);
    EXPECT_EQ(all.at(2), &all.steps[2]);
    EXPECT_EQ(all.at(10), &all.steps[4]);
    EXPECT_EQ(all.at(0.95), nullptr) << "the instant of the first merge";
    EXPECT_EQ(all.at(10.01), nullptr);
    EXPECT_EQ(all.at(-1e-9), nullptr);
}

TEST(Steps, EventsThatAreNotToldApartAreOneMoment) {
    // Four at once, with the group's numbers on each; then one with no numbers at all.
    TimelineRecord record = complete({5, 0, 0}, std::vector<Event>(4, event_at(11, Kind::merge)));
    for (Event& event : record.timeline.events) {
        event.before = Betti{5, 0, 0};
        event.after = Betti{1, 0, 0};
    }
    record.timeline.events.push_back(event_at(50, Kind::void_forms));
    record.timeline.end = std::nullopt;
    record.timeline.end_is_proved = false;
    const Steps all = steps_of(record.timeline);
    ASSERT_EQ(all.instants.size(), 2u);
    EXPECT_EQ(all.instants[0].events.size(), 4u);
    EXPECT_EQ(all.steps[1].solid, (Betti{1, 0, 0}));
    EXPECT_EQ(all.steps[2].solid, (Betti{1, 0, 1})) << "by the change of its kind";
    EXPECT_TRUE(all.steps[2].is_proved);
}

TEST(Steps, OfEventsThatOverlapTheOrderOfTheListCounts) {
    // Ordered by the middles of their times; the first begins first, and ends last.
    TimelineRecord record =
        complete({3, 0, 0}, {event_at(12, Kind::merge), event_at(12.5, Kind::merge)});
    record.timeline.events[0].time = {0.9, 1.3};
    record.timeline.events[1].time = {1.15, 1.2};
    Steps all = steps_of(record.timeline);
    ASSERT_EQ(all.instants.size(), 1u);
    EXPECT_EQ(all.steps[0].solid, (Betti{3, 0, 0}));
    EXPECT_EQ(all.steps[1].solid, (Betti{1, 0, 0}));
    EXPECT_TRUE(all.steps[1].is_proved);
    // The second begins first: what is before it is between the two.
    record.timeline.events[0].time = {1.15, 1.2};
    record.timeline.events[1].time = {0.9, 1.5};
    record.timeline.start = std::nullopt;
    all = steps_of(record.timeline);
    EXPECT_EQ(all.steps[0].solid, (Betti{3, 0, 0}));
    // If the first is of unknown kind, only what is between them is known: no end of the instant.
    record.timeline.events[0].kind = Kind::unknown;
    record.timeline.events[0].before = std::nullopt;
    EXPECT_EQ(steps_of(record.timeline).steps[0].solid, std::nullopt);
}

TEST(Steps, WhatDoesNotChangeTheSolidIsNoMoment) {
    TimelineRecord record = story();
    record.timeline.events.insert(record.timeline.events.begin(), event_at(5, Kind::none));
    const Steps all = steps_of(record.timeline);
    EXPECT_EQ(all.instants.size(), 4u);
    EXPECT_EQ(all.instants.front().events, std::vector<std::size_t>{1});
}

TEST(Steps, ProofsReachFromBothEndsToTheDoubtfulEvent) {
    TimelineRecord record = story();
    record.timeline.events[1].kind = Kind::unknown;
    const Steps all = steps_of(record.timeline);
    for (const Step& step : all.steps) EXPECT_TRUE(step.is_proved); // one side each
    record.timeline.end_is_proved = false;
    const Steps cut = steps_of(record.timeline);
    EXPECT_TRUE(cut.steps[1].is_proved);
    EXPECT_FALSE(cut.steps[2].is_proved);
    // With two of them nothing reaches between.
    record = story();
    record.timeline.events[1].is_proved = record.timeline.events[2].is_proved = false;
    EXPECT_FALSE(steps_of(record.timeline).steps[2].is_proved);
}

TEST(Steps, NothingIsProvedWhereAnEventMayBeMissing) {
    for (const bool by_doubt : {false, true}) {
        TimelineRecord record = story();
        record.timeline.is_proved = by_doubt;
        if (by_doubt) record.timeline.doubts.push_back("the sum does not agree");
        for (const Step& step : steps_of(record.timeline).steps) EXPECT_FALSE(step.is_proved);
    }
}

TEST(Steps, TheEndsOwnNumberStandsForIt) {
    TimelineRecord record = story();
    record.timeline.end = Betti{7, 7, 7};
    const Steps all = steps_of(record.timeline);
    EXPECT_EQ(all.steps[4].solid, (Betti{7, 7, 7}));
    EXPECT_TRUE(all.steps[4].is_proved);
    EXPECT_TRUE(all.steps[3].is_proved) << "from the start";
    record.timeline.start_is_proved = false;
    EXPECT_FALSE(steps_of(record.timeline).steps[3].is_proved) << "the end does not lead there";
}

TEST(Steps, NoProofReachesAcrossAnEventThatMayBeOutside) {
    TimelineRecord record = story();
    record.timeline.range.lo = 0.95; // in the enclosure of the first
    Steps all = steps_of(record.timeline);
    for (const Step& step : all.steps) EXPECT_TRUE(step.is_proved) << "one side each";
    record.timeline.end_is_proved = false;
    all = steps_of(record.timeline);
    for (std::size_t k = 1; k < 5; ++k) EXPECT_FALSE(all.steps[k].is_proved) << k;
}

TEST(Steps, AnUnresolvedPlaceHasItsNumbersAboutIt) {
    TimelineRecord record = complete({3, 0, 0}, {});
    record.timeline.unresolved.push_back(
        {{4.9, 5.1}, {}, "degenerate", Betti{3, 0, 0}, Betti{1, 0, 0}});
    record.timeline.end = Betti{1, 0, 0};
    const Steps all = steps_of(record.timeline);
    ASSERT_EQ(all.steps.size(), 2u);
    EXPECT_EQ(all.steps[1].solid, (Betti{1, 0, 0}));
    EXPECT_EQ(all.at(5), nullptr);
}

TEST(Steps, WithoutAnythingThereIsOneUnknownStep) {
    Timeline timeline;
    timeline.range = {0, 1};
    const Steps all = steps_of(timeline);
    ASSERT_EQ(all.steps.size(), 1u);
    EXPECT_FALSE(all.steps[0].solid);
    EXPECT_FALSE(all.steps[0].is_proved);
}

} // namespace
} // namespace isomotion::topology
