// What people claim, in JSON and TOML, and the verdict on it.
#include "topology/timeline/expectation.h"

#include <fstream>

#include <gmock/gmock.h>

#include "base/input_error.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timelines.h"
#include "unit/image/places.h"

namespace isomotion::topology::expectation_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr animation::FrameRate fps{10, 1};

Check of(const std::string& json, const TimelineRecord& found = story()) {
    return check(parse_claims(json, "e.json", fps), found);
}

std::string mistake(const std::string& text, const std::string& file = "e.json") {
    try {
        parse_claims(text, file, fps);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "no mistake";
}

TEST(Expectation, ClaimsOfBettiNumbers) {
    const Check right =
        of(R"({"components": {"1": 3, "12": 2, "10.4": 3, "21..101": 1, "10.5..20": 2},
                               "tunnels": {"40.3..90.6": 1, "40.1": 0, "101": 0},
                               "voids": {"1..101": 0}})");
    EXPECT_EQ(right.outcome(), Outcome::passes);
    EXPECT_THAT(right.undecided, IsEmpty());
    EXPECT_EQ(right.agreed, 9u);
    const Check wrong = of(R"({"components": {"12": 3, "1..20": 3}, "tunnels": {"40..41": 1}})");
    EXPECT_EQ(wrong.outcome(), Outcome::differs);
    EXPECT_THAT(wrong.differences, ElementsAre("components.1..20 = 3: 2 at frame 10.5",
                                               "components.12 = 3: 2 at frame "
                                               "12",
                                               "tunnels.40..41 = 1: 0 at frame 40"));
}

TEST(Expectation, FramesMayBeTheEndsOfTheSearch) {
    const Check right = of(R"({"components": {"start": 3, "end": 1, "start..10.4": 3},
                               "tunnels": {"91..end": 0, "end": 0}})");
    EXPECT_EQ(right.outcome(), Outcome::passes);
    EXPECT_EQ(right.agreed, 5u);
    const Check wrong = of(R"({"components": {"end": 2, "15..end": 2}})");
    EXPECT_THAT(wrong.differences, ElementsAre("components.15..end = 2: 1 at frame 20.25",
                                               "components.end = 2: 1 at frame 101"));
    // Less was searched: the end is another, and what lies beyond it is not known.
    TimelineRecord less = complete({3, 0, 0}, {event_at(10.5, Kind::merge, {0.5, 0, 0})});
    less.timeline.range.hi = 2;
    EXPECT_EQ(of(R"({"components": {"end": 2}})", less).outcome(), Outcome::passes);
    EXPECT_EQ(of(R"({"components": {"30..end": 2}})", less).outcome(), Outcome::incomplete);
    EXPECT_EQ(of(R"({"components": {"start..30": 2}})", less).outcome(), Outcome::incomplete);
    // At the end is an event: its numbers are those of its instant.
    less.timeline.range.hi = less.timeline.events[0].time.hi;
    EXPECT_EQ(of(R"({"components": {"end": 2}})", less).outcome(), Outcome::incomplete);
}

TEST(Expectation, OneToleranceIsThatOfAllItsLoneFrames) {
    EXPECT_EQ(of(R"({"events": ["merge at frame 12"]})").outcome(), Outcome::differs);
    EXPECT_EQ(of(R"({"tolerance": 2, "events": ["merge at frame 12"]})").outcome(),
              Outcome::passes);
    EXPECT_EQ(of(R"({"events": ["merge at frame 12"], "tolerance": 1})").outcome(),
              Outcome::differs);
    EXPECT_THAT(mistake(R"({"tolerance": -1, "events": ["merge"]})"),
                HasSubstr("tolerance: must be a number of frames, 0 or more"));
    EXPECT_THAT(mistake(R"({"tolerance": "2", "events": ["merge"]})"), HasSubstr("tolerance: "));
}

TEST(Expectation, AtTheMomentOfAnEventNumbersAreOpen) {
    const Check instant = of(R"({"components": {"10.5": 3}})");
    EXPECT_EQ(instant.outcome(), Outcome::incomplete);
    EXPECT_THAT(instant.undecided, ElementsAre(HasSubstr("ask a little before or after it")));
    const Check beyond = of(R"({"components": {"102": 1}})");
    EXPECT_THAT(beyond.undecided, ElementsAre("components.102 = 1: frame 102 was not searched; "
                                              "searched were frames 1 to 101"));
}

TEST(Expectation, WithinAnInstantNoNumberIsTold) {
    // One place that is unresolved over the whole range.
    TimelineRecord found = complete({3, 0, 0}, {});
    found.timeline.unresolved.push_back({found.timeline.range, {}, "a curve of them", {}, {}});
    found.timeline.is_proved = false;
    EXPECT_EQ(of(R"({"components": {"1..101": 12345}})", found).outcome(), Outcome::incomplete);
    EXPECT_EQ(of(R"({"components": {"20..30": 3}})", found).outcome(), Outcome::incomplete);
    // Two frames that differ, and a span from one to the other.
    found.timeline.unresolved = {{{0.4, 0.5}, {}, "they differ", Betti{3, 0, 0}, Betti{2, 0, 0}}};
    found.timeline.end = Betti{2, 0, 0};
    EXPECT_EQ(of(R"({"components": {"5..6": 999}})", found).outcome(), Outcome::incomplete);
    // A merge and a split in an order that isn't known: 2, and 1 or 3, and 2.
    found = complete({2, 0, 0}, {event_at(20, Kind::merge), event_at(20.5, Kind::split)});
    for (Event& event : found.timeline.events) event.time = {1.8, 2.1};
    const Check check = of(R"({"components": {"1..101": 2, "19.5..21.5": 2, "20..21": 2},
                               "tunnels": {"1..101": 0}, "voids": {"20..101": 0}})",
                           found);
    EXPECT_THAT(check.differences, IsEmpty());
    EXPECT_EQ(check.undecided.size(), 3u);
    EXPECT_EQ(check.agreed, 2u) << "nothing there changes tunnels or voids";
    // An event of unknown kind in it opens all.
    found = story();
    found.timeline.events[1].kind = Kind::unknown;
    EXPECT_EQ(of(R"({"voids": {"15..25": 0}})", found).outcome(), Outcome::incomplete);
    // So does one without proof, whatever its kind would keep.
    found = story();
    EXPECT_EQ(of(R"({"voids": {"15..25": 0}})", found).outcome(), Outcome::passes);
    found.timeline.events[1].is_proved = false;
    EXPECT_EQ(of(R"({"voids": {"15..25": 0}})", found).outcome(), Outcome::incomplete);
}

TEST(Expectation, OnlyWhatIsProvedPassesOrFails) {
    TimelineRecord found = story();
    found.timeline.is_proved = false;
    for (const char* claim : {R"({"components": {"12": 2}})", R"({"components": {"12": 5}})"}) {
        const Check check = of(claim, found);
        EXPECT_EQ(check.outcome(), Outcome::incomplete) << claim;
        EXPECT_THAT(check.notes, ElementsAre("found: it is not proved that no event is missing"));
    }
    // Before an event of unknown kind, proved from the start on.
    found = story();
    found.timeline.events[1].kind = Kind::unknown;
    found.timeline.end_is_proved = false;
    EXPECT_EQ(of(R"({"components": {"12": 2}})", found).outcome(), Outcome::passes);
    EXPECT_EQ(of(R"({"components": {"50": 1}})", found).outcome(), Outcome::incomplete);
    // Nothing known at all.
    found.timeline = {};
    found.timeline.range = {0, 10};
    EXPECT_EQ(of(R"({"voids": {"1": 0}})", found).outcome(), Outcome::incomplete);
}

TEST(Expectation, ClaimsOfEvents) {
    const Check right = of(R"({"events": ["2 merges", "tunnel forms at frame 40.2",
                                          "tunnel closes at frame 90..91", "nothing else"]})");
    EXPECT_EQ(right.outcome(), Outcome::passes);
    const Check wrong = of(R"({"events": ["no split", "merge at frame 12..13"]})");
    EXPECT_THAT(wrong.differences, ElementsAre("events[1] \"merge at frame 12..13\": found 0; the "
                                               "nearest is a merge at frame 10.5"));
    EXPECT_EQ(wrong.agreed, 1u);
}

TEST(Expectation, TomlOfTheSameShape) {
    const auto claims =
        parse_claims("events = [\"2 merges\"]\n[components]\n1 = 3\n\"40.5\" = 1\n", "e.toml", fps);
    EXPECT_EQ(check(claims, story()).outcome(), Outcome::passes);
    EXPECT_EQ(claims.betti.size(), 2u);
    EXPECT_EQ(mistake("[components]\n40.5 = 1\n", "e.toml"),
              "e.toml:2: components.40: TOML takes the dots for tables of tables; put the frame in "
              "quotes: \"40.5\" = 2");
    EXPECT_THAT(mistake("[components\n", "e.toml"), StartsWith("e.toml:1: not valid TOML: "));
    EXPECT_EQ(mistake("[components]\n1 = 2020-01-01\n", "e.toml"),
              "e.toml:2: components.1: must be a number, a text, a list or a table, no date");
    EXPECT_THAT(mistake("[components]\n1 = nan\n", "e.toml"), HasSubstr("must be a whole number"));
}

TEST(Expectation, TomlMistakesNameTheLine) {
    EXPECT_THAT(mistake("events = [\n  \"2 merges\",\n  # one more\n  \"mege\",\n]\n", "e.toml"),
                StartsWith("e.toml:4: events[1]: "));
    EXPECT_THAT(mistake("[tunnels]\n1 = 0\n\nx = 2\n", "e.toml"),
                StartsWith("e.toml:4: tunnels.x: 'x' is no frame"));
    EXPECT_THAT(mistake("\n\ntunnels = 3\n", "e.toml"), StartsWith("e.toml:3: tunnels: "));
    EXPECT_THAT(mistake("component = 1\n", "e.toml"),
                StartsWith("e.toml:1: component: unknown key; did you mean 'components'?"));
}

TEST(Expectation, MistakesNameTheKey) {
    const std::pair<const char*, const char*> wrongs[] = {
        {"", "e.json: not valid JSON: "},
        {"[]", "e.json: must be an object, in { }"},
        {"{}", "e.json: claims nothing; write { \"components\": { \"1\": 2 }"},
        {R"({"events": []})", "e.json: claims nothing"},
        {R"({"component": {"1": 2}})", "component: unknown key; did you mean 'components'?"},
        {R"({"components": 3})", "components: must be an object, in { }"},
        {R"({"components": {"one": 3}})", "components.one: 'one' is no frame; write \"12\""},
        {R"({"components": {"9..5": 3}})", "components.9..5: '9..5' is no frame"},
        {R"({"components": {"inf": 3}})", "'inf' is no frame"},
        {R"({"components": {"1": "3"}})", "components.1: must be a whole number from 0 to"},
        {R"({"components": {"1": -3}})", "components.1: must be a whole number from 0 to"},
        {R"({"components": {"1": 2.5}})", "components.1: must be a whole number from 0 to"},
        {R"({"components": {"1": 3, "1": 4}})", "e.json:1: components.1: is given twice; keep one"},
        {R"({"components": {"1": 3}, "components": {"2": 4}})", "components: is given twice"},
        {R"({"events": "no split"})", "events: must be a list, in [ ]"},
        {R"({"events": ["no split", 3]})", "events[1]: must be a text"},
        {R"({"events": ["no split", "mege"]})",
         "e.json:1: events[1]: \"mege\": there is no event 'mege'; did you mean 'merge'?"},
    };
    for (const auto& [text, message] : wrongs) {
        EXPECT_THAT(mistake(text), HasSubstr(message)) << text;
        EXPECT_THAT(mistake(text), StartsWith("e.json:")) << text;
    }
}

TEST(Expectation, AFileIsATimelineOrClaims) {
    const image::TemporaryFolder folder;
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    };
    const auto timeline = read_expectation(write("a.json", to_json(story())), fps);
    EXPECT_TRUE(std::holds_alternative<TimelineRecord>(timeline));
    EXPECT_EQ(check(timeline, story()).outcome(), Outcome::passes);
    const auto claims = read_expectation(write("b.json", R"({"events": ["2 merges"]})"), fps);
    EXPECT_EQ(check(claims, story()).outcome(), Outcome::passes);
    EXPECT_EQ(
        check(read_expectation(write("c.toml", "events = [\"split\"]"), fps), story()).outcome(),
        Outcome::differs);
    EXPECT_THROW(read_expectation(folder / "none.json", fps), base::InputError);
    EXPECT_THROW(read_expectation(write("d.json", R"({"format": "x", "version": 1})"), fps),
                 base::InputError);
}

TEST(Expectation, TheVerdictIsInWords) {
    EXPECT_EQ(text(of(R"({"events": ["2 merges", "no split"]})"), "e.json"),
              "e.json: passes, 2 agree\n");
    EXPECT_EQ(text(of(R"({"events": ["3 merges", "no split"]})"), "e.json"),
              "events[0] \"3 merges\": found 2\n"
              "e.json: differs, 1 difference, 0 undecided, 1 agree\n");
    TimelineRecord open = story();
    open.timeline.is_proved = false;
    EXPECT_EQ(text(of(R"({"events": ["no split"]})", open), "e.json"),
              "undecided: events[0] \"no split\": found 0, and it is not proved that there are no "
              "more\n"
              "note: found: it is not proved that no event is missing\n"
              "e.json: INCOMPLETE, neither passed nor failed: 1 undecided, 0 agree\n");
}

} // namespace
} // namespace isomotion::topology::expectation_test
