// Compares timelines. Every edit is found for what it is, and said once.
#include "topology/timeline/compare.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr double dt = 1e-9;

void move_by(Event& event, double seconds) {
    event.time = {event.time.lo + seconds, event.time.hi + seconds};
}

TEST(Compare, ATimelineEqualsItself) {
    std::mt19937_64 random(1);
    for (const int count : {0, 1, 2, 30, 500}) {
        const TimelineRecord record = random_complete(random, count);
        const Check check = compare(record, record, dt);
        EXPECT_EQ(check.outcome(), Outcome::passes);
        EXPECT_EQ(check.agreed, std::size_t(count));
        EXPECT_THAT(check.notes, IsEmpty());
    }
}

// Pairs of a stranger's events and those that were found are not all weighed.
TEST(Compare, TooManyThatDifferAreToldOneByOne) {
    std::vector<Event> wanted, had;
    for (int k = 0; k < 2100; ++k) {
        wanted.push_back(event_at(2 + k * 0.04, Kind::birth));
        had.push_back(event_at(2.02 + k * 0.04, Kind::birth));
    }
    const Check check = compare(complete({1, 0, 0}, wanted), complete({1, 0, 0}, had), dt);
    EXPECT_EQ(check.outcome(), Outcome::differs);
    EXPECT_EQ(check.differences.size(), 4200u);
    EXPECT_THAT(check.notes, testing::Contains(HasSubstr("2100 events that are expected and 2100 "
                                                         "that were found are too many")));
}

TEST(Compare, AMoveWithinTheToleranceIsNone) {
    TimelineRecord found = story();
    move_by(found.timeline.events[1], 0.9e-9);
    EXPECT_EQ(compare(story(), found, dt).outcome(), Outcome::passes);
    move_by(found.timeline.events[1], 0.3e-9);
    EXPECT_EQ(compare(story(), found, dt).outcome(), Outcome::differs);
    EXPECT_EQ(compare(story(), found, 1e-8).outcome(), Outcome::passes);
}

TEST(Compare, SaysOneLineForEachEdit) {
    TimelineRecord moved = story();
    move_by(moved.timeline.events[0], 0.012);
    EXPECT_THAT(compare(story(), moved, dt).differences,
                ElementsAre("moved: merge at frame 10.62 (0.962 s), near (0.5, 0, 0), expected at "
                            "frame 10.5: +0.012 s, +0.12 frames"));

    TimelineRecord elsewhere = story();
    elsewhere.timeline.events[0].where[1] = near(0.25);
    EXPECT_THAT(compare(story(), elsewhere, dt).differences,
                ElementsAre("elsewhere: merge at frame 10.5 (0.95 s), near (0.5, 0.25, 0), 0.25 "
                            "from where it was expected"));

    TimelineRecord other = story();
    other.timeline.events[0].kind = Kind::tunnel_forms;
    EXPECT_THAT(compare(story(), other, dt).differences,
                ElementsAre(StartsWith("kind: tunnel forms at frame 10.5 (0.95 s), near (0.5, 0, "
                                       "0), expected merge")));

    TimelineRecord more = story();
    more.timeline.events.push_back(event_at(95, Kind::birth, {0, 0, 0.9}));
    more.timeline.end->components += 1;
    EXPECT_THAT(compare(story(), more, dt).differences,
                ElementsAre(StartsWith("extra: birth at frame 95 (9.4 s), near (0, 0, 0.9)"),
                            StartsWith("betti: at the end, frame 101: 2 components, ")));
    EXPECT_THAT(compare(more, story(), dt).differences,
                ElementsAre(StartsWith("missing: birth at frame 95 (9.4 s), near (0, 0, 0.9)"),
                            StartsWith("betti: at the end, frame 101: 1 component, ")));

    TimelineRecord end = story();
    end.timeline.events.back().after = end.timeline.end = Betti{1, 3, 0};
    EXPECT_THAT(compare(story(), end, dt).differences,
                ElementsAre(StartsWith("betti: tunnel closes at frame 90.7"),
                            "betti: at the end, frame 101: 1 component, 3 tunnels, 0 voids; "
                            "expected 1 component, 0 tunnels, 0 voids"));
}

// The property: of random edits of a random timeline each is told, by its own word, and no more.
TEST(Compare, RandomEditsAreToldAsTheyWere) {
    const std::uint64_t seed = 815;
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 60; ++trial) {
        const TimelineRecord before = random_complete(random, 40);
        TimelineRecord after = before;
        auto& events = after.timeline.events;
        std::size_t moved = 0, kinds = 0, missing = 0;
        std::vector<Event> kept;
        for (Event& event : events) {
            event.before = event.after = std::nullopt; // each stands for itself here
            switch (random() % 8) {
            case 0:
                move_by(event, 1e-7 * double(1 + random() % 1000));
                ++moved;
                break;
            case 1:
                event.kind = event.kind == Kind::split ? Kind::birth : Kind::split;
                ++kinds;
                break;
            case 2:
                ++missing;
                continue;
            default:
                break;
            }
            kept.push_back(event);
        }
        events = kept;
        const Check check = compare(before, after, dt);
        const auto count = [&](const char* word) {
            return std::size_t(
                std::ranges::count_if(check.differences, [&](const std::string& line) {
                    return line.starts_with(word);
                }));
        };
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", trial " << trial);
        EXPECT_EQ(count("moved:"), moved);
        EXPECT_EQ(count("kind:"), kinds);
        EXPECT_EQ(count("missing:"), missing);
        EXPECT_EQ(count("extra:"), 0u);
    }
}

TEST(Compare, SimultaneousEventsAreToldApartByPlace) {
    std::vector<Event> group;
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
            for (const double z : {-0.5, 0.5}) {
                group.push_back(event_at(30, Kind::merge, {x, y, z}));
            }
        }
    }
    const TimelineRecord expected = complete({9, 0, 0}, group);
    std::mt19937_64 random(3);
    std::shuffle(group.begin(), group.end(), random);
    TimelineRecord found = complete({9, 0, 0}, group);
    EXPECT_EQ(compare(expected, found, dt).outcome(), Outcome::passes);
    // All at another time: each is moved, none missing.
    for (Event& event : found.timeline.events) move_by(event, 0.5);
    const Check moved = compare(expected, found, dt);
    EXPECT_EQ(moved.differences.size(), 8u);
    for (const std::string& line : moved.differences) {
        EXPECT_THAT(line, StartsWith("moved: merge at frame 35 "));
    }
    // One of them alone.
    found = complete({9, 0, 0}, group);
    move_by(found.timeline.events.back(), 2e-9);
    EXPECT_EQ(compare(expected, found, dt).differences.size(), 1u);
}

TEST(Compare, WhatIsFarAwayIsAnotherEvent) {
    const TimelineRecord expected = complete({1, 0, 0}, {event_at(5, Kind::birth, {-0.9, 0, 0})});
    const TimelineRecord found = complete({1, 0, 0}, {event_at(95, Kind::birth, {0.9, 0, 0})});
    EXPECT_THAT(compare(expected, found, dt).differences,
                ElementsAre(StartsWith("missing:"), StartsWith("extra:")));
}

TEST(Compare, NothingPassesThatIsNotProved) {
    const auto incomplete_by = [](auto&& edit) {
        TimelineRecord found = story();
        edit(found.timeline);
        const Check one = compare(story(), found, dt), other = compare(found, story(), dt);
        EXPECT_EQ(one.outcome(), Outcome::incomplete);
        EXPECT_EQ(other.outcome(), Outcome::incomplete);
        for (const std::string& line : other.undecided) {
            EXPECT_THAT(line, StartsWith("the expectation itself is incomplete: "));
        }
        EXPECT_FALSE(one.undecided.empty());
        return one;
    };
    incomplete_by([](Timeline& t) { t.is_proved = false; });
    incomplete_by([](Timeline& t) { t.doubts.push_back("interrupted"); });
    incomplete_by([](Timeline& t) { t.events[2].is_proved = false; });
    incomplete_by([](Timeline& t) { t.start_is_proved = false; });
    incomplete_by([](Timeline& t) { t.end.reset(); });
    incomplete_by([](Timeline& t) { t.unresolved.push_back({{4, 5}, {}, "flat", {}, {}}); });
    TimelineRecord unknown = story();
    unknown.timeline.events[2].kind = Kind::unknown;
    const Check check = compare(story(), unknown, dt);
    EXPECT_EQ(check.outcome(), Outcome::incomplete);
    EXPECT_THAT(check.undecided.back(),
                StartsWith("kind: unknown at frame 40.2 (3.92 s), near (0, 0.5, 0), expected tun"));
}

TEST(Compare, AMissingEventIsOneOnlyWhereTheSearchIsProved) {
    TimelineRecord found = story();
    found.timeline.events.erase(found.timeline.events.begin() + 1);
    EXPECT_EQ(compare(story(), found, dt).outcome(), Outcome::differs);
    found.timeline.is_proved = false;
    const Check open = compare(story(), found, dt);
    EXPECT_EQ(open.outcome(), Outcome::incomplete);
    EXPECT_THAT(open.undecided.back(), StartsWith("not found: merge at frame 20.25"));
    // A proved event too many is one, however the search ended.
    TimelineRecord more = story();
    more.timeline.is_proved = false;
    more.timeline.events.push_back(event_at(95, Kind::birth));
    EXPECT_EQ(compare(story(), more, dt).outcome(), Outcome::differs);
}

TEST(Compare, ATimeKnownTooCoarselyDecidesNothing) {
    TimelineRecord coarse = story();
    coarse.timeline.events[0].time = {0.94, 0.96};
    const Check check = compare(story(), coarse, dt);
    EXPECT_EQ(check.outcome(), Outcome::incomplete);
    EXPECT_THAT(check.undecided, ElementsAre(HasSubstr("its time is known to 0.02 s")));
    EXPECT_EQ(compare(story(), coarse, 0.03).outcome(), Outcome::passes);
}

TEST(Compare, OnlyTheTimeThatTheExpectationSpansCounts) {
    // Frames 1 to 31 have two events; the longer search has them and two more.
    TimelineRecord expected =
        complete({3, 0, 0}, {story().timeline.events[0], story().timeline.events[1]});
    expected.timeline.range.hi = 3;
    EXPECT_EQ(compare(expected, story(), dt).outcome(), Outcome::passes);
    const Check shorter = compare(story(), expected, dt);
    EXPECT_EQ(shorter.outcome(), Outcome::incomplete);
    EXPECT_EQ(shorter.undecided.front(),
              "searched were frames 1 to 31, expected are events of 1 to 101");
}

// Unless one of them is of a former version, which doesn't say.
TEST(Compare, AnotherSideOfFDiffers) {
    TimelineRecord expected = story(), found = story();
    expected.header.solids = {-1};
    EXPECT_EQ(compare(expected, found, dt).outcome(), Outcome::passes);
    EXPECT_EQ(compare(found, expected, dt).outcome(), Outcome::passes);
    found.header.solids = {1};
    const Check check = compare(expected, found, dt);
    EXPECT_EQ(check.outcome(), Outcome::differs);
    EXPECT_THAT(check.differences,
                ElementsAre("solid: F > 0, expected F < 0; --solid chooses the side of F"));
    expected.header.solids = {1};
    EXPECT_EQ(compare(expected, found, dt).outcome(), Outcome::passes);
}

TEST(Compare, AnotherSceneIsNoted) {
    TimelineRecord found = story();
    found.header.fingerprint = "f";
    const Check check = compare(story(), found, dt);
    EXPECT_EQ(check.outcome(), Outcome::passes);
    EXPECT_THAT(check.notes, ElementsAre(HasSubstr("not the one that the expectation was made")));
    found = story();
    found.header.end_bounds[1] = {-2, 2};
    found.header.fps = {20, 1};
    EXPECT_THAT(compare(story(), found, dt).notes,
                ElementsAre("the bounds are not those of the expectation",
                            HasSubstr("the frame rate is not the expectation's")));
}

TEST(Compare, SaysOneLineForEachFieldOfACriticalPoint) {
    TimelineRecord other = story();
    other.timeline.events[0].stratum = 1;
    EXPECT_THAT(compare(other, story(), dt).differences,
                ElementsAre("stratum: merge at frame 10.5 (0.95 s), near (0.5, 0, 0) inside, "
                            "expected on an edge"));
    other = story();
    other.timeline.events[0].index = 3;
    other.timeline.events[0].grows = false;
    EXPECT_THAT(compare(other, story(), dt).differences,
                ElementsAre(StartsWith("index: merge at frame 10.5"),
                            StartsWith("direction: merge at frame 10.5")));
}

TEST(Compare, AnExpectationThatContradictsItselfSaysWhere) {
    TimelineRecord other = story();
    other.timeline.events[1].before = Betti{5, 0, 0};
    other.timeline.events[1].after = Betti{4, 0, 0};
    EXPECT_THAT(compare(other, story(), dt).differences,
                ElementsAre("the expectation contradicts itself: merge at frame 20.25: before it "
                            "are 5 components, 0 tunnels, 0 voids; what comes before it leaves 2 "
                            "components, 0 tunnels, 0 voids",
                            StartsWith("the expectation contradicts itself: tunnel forms at frame "
                                       "40.2: before it are 1 component")));
    other = story();
    other.timeline.end = Betti{1, 1, 0};
    EXPECT_THAT(compare(other, story(), dt).differences,
                ElementsAre("betti: at the end, frame 101: 1 component, 0 tunnels, 0 voids; "
                            "expected 1 component, 1 tunnel, 0 voids"));
}

TEST(Compare, AKindKnownOnlyTogetherIsLessThanOnesOwn) {
    TimelineRecord found = story();
    found.timeline.events[0].kind_proof = "together";
    EXPECT_THAT(compare(story(), found, dt).undecided,
                ElementsAre(HasSubstr("that it is this one's kind is not proved")));
    EXPECT_EQ(compare(found, story(), dt).outcome(), Outcome::passes);
}

TEST(Compare, KindsKnownOnlyTogetherMayChangePlaces) {
    const auto at_once = [](std::array<Kind, 3> kinds) {
        TimelineRecord record = complete({4, 0, 0}, {event_at(12, kinds[0], {-0.5, 0, 0}),
                                                     event_at(12, kinds[1], {0, 0, 0}),
                                                     event_at(12, kinds[2], {0.5, 0, 0})});
        for (Event& event : record.timeline.events) event.kind_proof = "together";
        return record;
    };
    constexpr Kind merge = Kind::merge, tunnel = Kind::tunnel_forms;
    const TimelineRecord one = at_once({merge, merge, tunnel});
    EXPECT_EQ(compare(one, at_once({tunnel, merge, merge}), 1e-9).outcome(), Outcome::passes);
    TimelineRecord other = at_once({tunnel, tunnel, merge});
    const Check check = compare(one, other, 1e-9);
    EXPECT_EQ(check.outcome(), Outcome::differs);
    EXPECT_THAT(check.differences, testing::Contains(testing::HasSubstr("1 merge of events")));
    // A path tells which it is: then it is that one.
    other = at_once({tunnel, merge, merge});
    for (Event& event : other.timeline.events) event.kind_proof = "path";
    EXPECT_EQ(compare(one, other, 1e-9).outcome(), Outcome::differs);
}

} // namespace
} // namespace isomotion::topology
