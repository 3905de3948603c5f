// What people say of events: the grammar, and when it is true.
#include "topology/timeline/statement.h"

#include <climits>
#include <stdexcept>

#include <gmock/gmock.h>

#include "topology/timeline/words.h"
#include "topology/timelines.h"

namespace isomotion::topology::statement_test {
namespace {

using testing::HasSubstr;

constexpr animation::FrameRate fps{10, 1};

TEST(Statement, SaysHowManyOfWhatAndWhen) {
    const struct {
        const char* text;
        int least, most;
        std::optional<Kind> kind;
        double from, to;
    } cases[] = {
        {"merge", 1, 1, Kind::merge, -HUGE_VAL, HUGE_VAL},
        {"a merge", 1, 1, Kind::merge, -HUGE_VAL, HUGE_VAL},
        {"an event", 1, 1, {}, -HUGE_VAL, HUGE_VAL},
        {"no split", 0, 0, Kind::split, -HUGE_VAL, HUGE_VAL},
        {"  no   splits ", 0, 0, Kind::split, -HUGE_VAL, HUGE_VAL},
        {"merge at frame 12..13", 1, 1, Kind::merge, 12, 13},
        {"74 merges at frames 12..130.5", 74, 74, Kind::merge, 12, 130.5},
        {"tunnel closes at frame 40.2", 1, 1, Kind::tunnel_closes, 40.15, 40.25},
        {"2 tunnels close at frame 40", 2, 2, Kind::tunnel_closes, 39.5, 40.5},
        {"3 births between frames 5 and 9", 3, 3, Kind::birth, 5, 9},
        {"2..4 voids born before frame 7", 2, 4, Kind::void_born, -HUGE_VAL, 7},
        {"at least 2 events after frame 90.5", 2, INT_MAX, {}, 90.5, HUGE_VAL},
        {"at most 1 void fills", 0, 1, Kind::void_fills, -HUGE_VAL, HUGE_VAL},
        {"death at time 0.50 s", 1, 1, Kind::death, 5.95, 6.05},
        {"deaths between times 0.5 and 1", 1, 1, Kind::death, 6, 11},
        {"one merge", 1, 1, Kind::merge, -HUGE_VAL, HUGE_VAL},
        {"at least two splits", 2, INT_MAX, Kind::split, -HUGE_VAL, HUGE_VAL},
        {"twelve births at 0.50 s", 12, 12, Kind::birth, 5.95, 6.05},
        {"birth at 0.5s", 1, 1, Kind::birth, 5.5, 6.5},
        {"birth at 0.25..0.75 s", 1, 1, Kind::birth, 3.5, 8.5},
        {"birth between 0.5 s and 1 s", 1, 1, Kind::birth, 6, 11},
        {"birth between 0.5 s and end", 1, 1, Kind::birth, 6, HUGE_VAL},
        {"birth before 1.28 s", 1, 1, Kind::birth, -HUGE_VAL, 13.8},
        {"merge at frame 90..end", 1, 1, Kind::merge, 90, HUGE_VAL},
        {"merge at frame start..7", 1, 1, Kind::merge, -HUGE_VAL, 7},
        {"merge between frames 90 and end", 1, 1, Kind::merge, 90, HUGE_VAL},
        {"merge at frame 40 +- 2", 1, 1, Kind::merge, 38, 42},
        {"merge at frame 40.2+-0.5 frames", 1, 1, Kind::merge, 39.7, 40.7},
        {"merge at frame 40 ± 0.3 s", 1, 1, Kind::merge, 37, 43},
        {"merge at 0.5 s +- 0.1", 1, 1, Kind::merge, 5, 7},
        {"merge at 0.5 s +- 2 frames", 1, 1, Kind::merge, 4, 8},
        {"merge on the bounds at frame 12..13", 1, 1, Kind::merge, 12, 13},
        {"No merges.", 0, 0, Kind::merge, -HUGE_VAL, HUGE_VAL},
        {"Exactly three splits", 3, 3, Kind::split, -HUGE_VAL, HUGE_VAL},
        {"One merge at 0.50 seconds.", 1, 1, Kind::merge, 5.95, 6.05},
        {"merge at 0.5 sec +/- 0.1", 1, 1, Kind::merge, 5, 7},
        {"merge before the end", 1, 1, Kind::merge, -HUGE_VAL, HUGE_VAL},
        {"merge between frame 5 and frame 9", 1, 1, Kind::merge, 5, 9},
        {"merge between frame 5 and 9", 1, 1, Kind::merge, 5, 9},
        {"merge from frame 90 to the end", 1, 1, Kind::merge, 90, HUGE_VAL},
        {"merge from 0.5 s to 1 s", 1, 1, Kind::merge, 6, 11},
        {"merge between the start and frame 9.", 1, 1, Kind::merge, -HUGE_VAL, 9},
    };
    for (const auto& c : cases) {
        SCOPED_TRACE(c.text);
        const Statement statement = parse_statement(c.text, fps);
        EXPECT_EQ(statement.least, c.least);
        EXPECT_EQ(statement.most, c.most);
        EXPECT_EQ(statement.kind, c.kind);
        if (std::isfinite(c.from))
            EXPECT_NEAR(statement.frames.lo, c.from, 2e-6);
        else
            EXPECT_EQ(statement.frames.lo, c.from);
        if (std::isfinite(c.to))
            EXPECT_NEAR(statement.frames.hi, c.to, 2e-6);
        else
            EXPECT_EQ(statement.frames.hi, c.to);
    }
    EXPECT_TRUE(parse_statement("nothing else", fps).is_nothing_else);
}

TEST(Statement, OneToleranceIsThatOfAllLoneFrames) {
    const auto frames = [](const char* text) { return parse_statement(text, fps, 2.5).frames; };
    EXPECT_NEAR(frames("merge at frame 40").lo, 37.5, 2e-6);
    EXPECT_NEAR(frames("merge at frame 40").hi, 42.5, 2e-6);
    EXPECT_NEAR(frames("merge at 0.5 s").lo, 3.5, 2e-6);
    EXPECT_NEAR(frames("merge at frame 40 +- 1").lo, 39, 2e-6) << "its own goes before";
    EXPECT_NEAR(frames("merge at frame 40..41").lo, 40, 2e-6) << "ends of spans are exact";
    EXPECT_EQ(frames("merge").lo, -HUGE_VAL);
}

TEST(Statement, EveryKindHasItsWords) {
    for (int k = int(Kind::birth); k < int(Kind::none); ++k) {
        const Kind kind = Kind(k);
        EXPECT_EQ(parse_statement(name(kind), fps).kind, kind) << name(kind);
        EXPECT_EQ(parse_statement("2 " + plural(kind), fps).kind, kind) << plural(kind);
    }
}

TEST(Statement, MistakesSayWhatWouldBeRight) {
    const std::pair<const char*, const char*> wrongs[] = {
        {"", "is empty; write what happens"},
        {"3", "says no event; write \"3 merges\""},
        {"mege at frame 3", "there is no event 'mege'; did you mean 'merge'?"},
        {"tunnel close", "did you mean 'tunnel closes'?"},
        {"tunnel", "there is no event 'tunnel'"},
        {"unknown", "there is no event 'unknown'; known: event, birth, death"},
        {"-1 merges", "there is no event '-1'"},
        {"4..2 merges", "'4..2' is no range of numbers; write 2..4"},
        {"99999999999 merges", "there is no event '99999999999'"},
        {"at frame 12 merge", "what happens comes before when"},
        {"at least merges", "'at least' needs a whole number"},
        {"merge frame 12", "'frame' is not when; write \"at frame 12\""},
        {"merge at 12", "12 of what? Write \"frame 12\" or \"12 s\""},
        {"merge at 12..13", "12..13 of what? Write \"frame 12..13\" or \"12..13 s\""},
        {"merge at noon", "'noon' is not what a time begins with"},
        {"merge at frame end", "write a span that ends there: \"at frame 119..end\""},
        {"merge after frame end", "no time is after the end"},
        {"merge at frame 12 +-", "'+-' needs a number"},
        {"merge at frame 12 +- -1", "'+-' needs a number"},
        {"merge on bounds", "write \"2 births on the bounds\""},
        {"merge at frame end..12", "ends before it begins"},
        {"merge at frame", "ends where a number should be"},
        {"merge at frame x", "'x' is no number"},
        {"merge at frame nan", "'nan' is no number"},
        {"merge at frame 1e400", "'1e400' is no number"},
        {"merge at frame 12...13", "'12...13' is no range: write 12..13"},
        {"merge at frame 13..12", "ends before it begins: 13 to 12"},
        {"merge between frames 5 to 9", "write \"between frames 5 and 9\""},
        {"merge from frame 5 and 9", "write \"from frame 5 to 9\""},
        {"exactly merges", "'exactly' needs a whole number"},
        {"exactly at least 2 merges", "'exactly' needs a whole number"},
        {"merge at frame 12 or so", "goes on after its end, at 'or'"},
        {"nothing", "did you mean \"nothing else\"?"},
        {"nothing else happens", "did you mean \"nothing else\"?"},
    };
    const std::string huge = "merge at time 1" + std::string(308, '0'); // more frames than doubles
    EXPECT_THROW(parse_statement(huge, fps), std::invalid_argument);
    for (const auto& [text, message] : wrongs) {
        try {
            parse_statement(text, fps);
            ADD_FAILURE() << text;
        } catch (const std::invalid_argument& error) {
            EXPECT_THAT(error.what(), HasSubstr(message)) << text;
        }
    }
}

Judgement judged(const std::vector<std::string>& texts, const Timeline& timeline) {
    std::vector<Statement> all;
    for (const std::string& text : texts) all.push_back(parse_statement(text, fps));
    return judge(all.back(), all, timeline, fps);
}

TEST(Statement, HoldsOrFailsByACompleteTimeline) {
    const Timeline timeline = story().timeline; // merges 10.5, 20.25; tunnel 40.2 to 90.7
    for (const char* text :
         {"2 merges", "merge at frame 10..11", "merge at frame 10.5", "merge at frame 20.2",
          "no split", "4 events", "tunnel closes after frame 90", "at least 2 merges",
          "at most 2 merges", "0 births", "tunnel forms at frame 40.2..41",
          "1..3 events "
          "between frames 15 and 45",
          "no event between frames 50 and 90", "merge at time 0.95"}) {
        EXPECT_EQ(judged({text}, timeline).truth, Truth::holds) << text;
    }
    for (const char* text : {"merge", "3 merges", "split", "merge at frame 12", "at least 3 merges",
                             "at most 1 merge", "no events", "merge at frame 12..13"}) {
        EXPECT_EQ(judged({text}, timeline).truth, Truth::fails) << text;
    }
    EXPECT_EQ(judged({"merge at frame 12..13"}, timeline).why,
              "found 0; the nearest is a merge at frame 10.5");
    EXPECT_EQ(judged({"merge"}, timeline).why, "found 2");
}

TEST(Statement, IsOfEventsInsideOrOnTheBounds) {
    TimelineRecord record = story(); // merges 10.5, 20.25; tunnel 40.2 to 90.7
    Timeline& timeline = record.timeline;
    timeline.events[1].stratum = 2;
    for (const char* text :
         {"merge on the bounds", "merge inside at frame 10.5", "one event on the bounds",
          "3 events inside", "no split on the bounds", "2 merges"}) {
        EXPECT_EQ(judged({text}, timeline).truth, Truth::holds) << text;
    }
    for (const char* text : {"merge inside at frame 20.25", "no merge on the bounds",
                             "2 merges inside", "merge on the bounds at frame 10.5"}) {
        EXPECT_EQ(judged({text}, timeline).truth, Truth::fails) << text;
    }
    EXPECT_EQ(judged({"3 events inside", "nothing else"}, timeline).why,
              "there is merge at frame 20.25");
    EXPECT_EQ(judged({"3 events inside", "event on the bounds", "nothing else"}, timeline).truth,
              Truth::holds);
    // Kinds that are known together only may be the other way round.
    timeline = complete({2, 0, 0}, {event_at(11.5, Kind::merge), event_at(12, Kind::tunnel_forms)})
                   .timeline;
    timeline.events[0].time = {1.0, 1.09};
    timeline.events[1].time = {1.05, 1.2};
    timeline.events[0].stratum = 2;
    for (Event& event : timeline.events) event.kind_proof = "together";
    EXPECT_EQ(judged({"merge on the bounds"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no tunnel forms on the bounds"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"event on the bounds"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"merge on the bounds", "tunnel forms", "nothing else"}, timeline).truth,
              Truth::open);
}

TEST(Statement, TheEndIsThatOfTheSearch) {
    const Timeline timeline = story().timeline; // frames 1 to 101, tunnel closes at 90.7
    EXPECT_EQ(judged({"tunnel closes at frame 90..end"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"2 merges at frame start..21"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"no event at frame 91..end"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"no event at frame 90..end"}, timeline).truth, Truth::fails);
    EXPECT_EQ(judged({"no event at frame 120..end"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no split at frame start..120"}, timeline).truth, Truth::open);
    Timeline across = timeline;
    across.events[3].time = {9.9, 10.1}; // over the end
    EXPECT_EQ(judged({"tunnel closes at frame 90..end"}, across).truth, Truth::open);
}

TEST(Statement, NothingElseCountsWhatNobodyMeant) {
    const Timeline timeline = story().timeline;
    EXPECT_EQ(judged({"2 merges", "tunnel forms", "tunnel closes", "nothing else"}, timeline).truth,
              Truth::holds);
    const Judgement rest =
        judged({"2 merges", "tunnel closes", "no births", "nothing else"}, timeline);
    EXPECT_EQ(rest.truth, Truth::fails);
    EXPECT_EQ(rest.why, "there is tunnel forms at frame 40.2");
    EXPECT_EQ(
        judged({"merge at frame 10.5", "2 tunnels form", "tunnel closes", "nothing else"}, timeline)
            .why,
        "there is merge at frame 20.25");
}

TEST(Statement, IsOpenWhereNothingIsProved) {
    Timeline open = story().timeline;
    open.is_proved = false;
    // There may be more; what there is is there.
    EXPECT_EQ(judged({"2 merges"}, open).truth, Truth::open);
    EXPECT_EQ(judged({"no split"}, open).truth, Truth::open);
    EXPECT_EQ(judged({"at most 2 merges"}, open).truth, Truth::open);
    EXPECT_EQ(judged({"3 merges"}, open).truth, Truth::open);
    EXPECT_EQ(judged({"at least 2 merges"}, open).truth, Truth::holds);
    EXPECT_EQ(judged({"no merge"}, open).truth, Truth::fails);
    EXPECT_EQ(judged({"a merge"}, open).truth, Truth::fails);
    EXPECT_EQ(judged({"event", "nothing else"}, open).truth, Truth::open);
    // One of them may be none.
    open.events[0].is_proved = false;
    EXPECT_EQ(judged({"at least 2 merges"}, open).truth, Truth::open);
    EXPECT_EQ(judged({"at most 1 merge"}, open).truth, Truth::open);
    EXPECT_EQ(judged({"no merge"}, open).truth, Truth::fails);

    Timeline doubtful = story().timeline;
    doubtful.doubts.push_back("the sum does not agree");
    EXPECT_EQ(judged({"2 merges"}, doubtful).truth, Truth::open);
    EXPECT_EQ(judged({"at least 2 merges"}, doubtful).truth, Truth::open);
}

TEST(Statement, OnlyTheUnresolvedWithinItsFramesMatters) {
    Timeline timeline = story().timeline;
    timeline.unresolved.push_back({{5, 5.1}, {}, "flat", {}, {}}); // frames 51 to 52
    EXPECT_EQ(judged({"merge at frame 10.5"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"no event between frames 45 and 51.5"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no split"}, timeline).truth, Truth::open);
}

TEST(Statement, AnUnknownKindMayBeTheOneMeant) {
    Timeline timeline = story().timeline;
    timeline.events[1].kind = Kind::unknown;
    EXPECT_EQ(judged({"2 merges"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"3 merges"}, timeline).truth, Truth::fails);
    EXPECT_EQ(judged({"2 merges"}, timeline).why, "found 1 to 2, not all of them told apart");
    EXPECT_EQ(judged({"4 events"}, timeline).truth, Truth::holds) << "whatever kind it is of";
    EXPECT_EQ(judged({"1..2 merges"}, timeline).truth, Truth::holds);
}

TEST(Statement, AnEventAcrossTheEndOfItsFramesIsOpen) {
    Timeline timeline = story().timeline;
    timeline.events[0].time = {0.9, 1.1}; // frames 10 to 12
    EXPECT_EQ(judged({"merge at frame 11..15"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"merge at frame 9..15"}, timeline).truth, Truth::holds);
    // It is not known to be the one that is meant.
    EXPECT_EQ(judged({"at most 1 merge at frame 9..11", "3 events after frame 12", "nothing else"},
                     timeline)
                  .truth,
              Truth::open);
}

TEST(Statement, FramesThatWereNotSearchedAreOpen) {
    const Timeline timeline = story().timeline; // frames 1 to 101
    EXPECT_EQ(judged({"no merge at frame 150"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no split between frames 90 and 120"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no split after frame 120"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no split after frame 90"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"no split at frame 100"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"no split between frames 1 and 101"}, timeline).truth, Truth::holds);
    // Frame 101 is half a frame that was searched and half a frame that was not.
    const Judgement last = judged({"no split at frame 101"}, timeline);
    EXPECT_EQ(last.truth, Truth::open);
    EXPECT_EQ(last.why, "found 0, but frames 101 to 101.5 were not searched; searched were frames "
                        "1 to 101");
    for (const char* text :
         {"no split at frame 1", "no split before frame 1", "no split after frame 101",
          "no split between frames 0.999999 and 3", "no split at time 10",
          "no split before frame 0", "no split between times 9 and 10.0000001",
          "2 merges before frame 102"}) {
        EXPECT_EQ(judged({text}, timeline).truth, Truth::open) << text;
    }
}

TEST(Statement, AnEventAcrossAnEndOfTheSearchMayBeOutside) {
    Timeline timeline = story().timeline;
    timeline.events[3].time = {9.9, 10.1};
    EXPECT_EQ(judged({"tunnel closes"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no tunnel closes"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"tunnel closes after frame 90"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"2 merges", "tunnel forms", "nothing else"}, timeline).truth, Truth::open);
    timeline.events[3].time = {9.9, 10};
    EXPECT_EQ(judged({"tunnel closes"}, timeline).truth, Truth::holds);
}

TEST(Statement, WhatChangesNothingIsNoEvent) {
    Timeline timeline = story().timeline;
    timeline.events.push_back(event_at(95, Kind::none));
    EXPECT_EQ(judged({"4 events"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"4 events", "nothing else"}, timeline).truth, Truth::holds);
}

TEST(Statement, KindsKnownOnlyTogetherAreNotPartedByFrames) {
    // The merge may be either, and either may be before frame 12.
    TimelineRecord record =
        complete({2, 0, 0}, {event_at(11.5, Kind::merge), event_at(12, Kind::tunnel_forms)});
    record.timeline.events[0].time = {1.0, 1.09};
    record.timeline.events[1].time = {1.05, 1.2};
    for (Event& event : record.timeline.events) event.kind_proof = "together";
    const Timeline& timeline = record.timeline;
    EXPECT_EQ(judged({"merge before frame 12"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"no tunnel forms before frame 11.95"}, timeline).truth, Truth::open);
    EXPECT_EQ(judged({"merge", "tunnel forms"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"merge between frames 10 and 14"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"2 merges between frames 10 and 14"}, timeline).truth, Truth::fails);
    EXPECT_EQ(judged({"nothing else", "merge", "tunnel forms"}, timeline).truth, Truth::holds);
    EXPECT_EQ(judged({"nothing else", "2 merges"}, timeline).truth, Truth::fails);
    EXPECT_EQ(
        judged({"nothing else", "merge before frame 12", "event after frame 12"}, timeline).truth,
        Truth::open);
}

} // namespace
} // namespace isomotion::topology::statement_test
