// The attack: of a true timeline every field is made wrong in turn, and nothing wrong passes.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/input_error.h"
#include "topology/timeline/expectation.h"
#include "topology/timeline/falsehoods.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

Outcome outcome(const TimelineRecord& expected, const TimelineRecord& found, double dt = 1e-9) {
    return check(Expectation(expected), found, dt).outcome();
}

// Whether it passes as the file that somebody would write of it. What cannot be read does not pass.
bool passes_as_text(const std::string& text, const TimelineRecord& found) {
    try {
        return outcome(parse_timeline(text, "lie.json"), found) == Outcome::passes;
    } catch (const base::InputError&) {
        return false;
    }
}

// Files are read for hundreds of edits of each event.
bool is_short(const TimelineRecord& record) { return record.timeline.events.size() <= 15; }

class CompleteTimeline : public testing::TestWithParam<NamedTimeline> {};

TEST_P(CompleteTimeline, PassesAndNothingElseDoes) {
    const TimelineRecord& truth = GetParam().record;
    const Check same = check(Expectation(truth), truth);
    EXPECT_EQ(same.outcome(), Outcome::passes) << text(same, GetParam().name);
    EXPECT_TRUE(passes_as_text(to_json(truth), truth));
    for (const double dt : {1e-9, 1e-3}) {
        if (dt > 1e-9 && !is_short(truth)) continue;
        const auto lies = falsehoods(GetParam(), dt);
        EXPECT_GT(lies.size(), 40 + 60 * (truth.timeline.events.size() / GetParam().every));
        for (const Falsehood& lie : lies) {
            EXPECT_NE(outcome(lie.record, truth, dt), Outcome::passes)
                << "it passes: " << lie.what << ", dt = " << dt;
            if (!is_short(truth) || dt > 1e-9) continue;
            EXPECT_FALSE(passes_as_text(to_json(lie.record), truth))
                << "it passes as a file: " << lie.what;
        }
        RecordProperty(dt < 1e-6 ? "fine" : "coarse", int(lies.size()));
    }
}

// What is found wrong is the same lie, told of the true expectation.
TEST_P(CompleteTimeline, NothingElseThatIsFoundPassesIt) {
    const TimelineRecord& truth = GetParam().record;
    for (const Falsehood& lie : falsehoods(GetParam(), 1e-9)) {
        // To have searched more, or proved more, is not to have found something else.
        const formula::Interval range = lie.record.timeline.range;
        const bool is_more = range != truth.timeline.range || lie.what.ends_with("proved again") ||
                             lie.what.ends_with("this very one is of its kind") ||
                             lie.what.ends_with("after all time");
        if (is_more) continue;
        EXPECT_NE(outcome(truth, lie.record), Outcome::passes) << "it passes: " << lie.what;
    }
}

// Texts and identities that say nothing of topology: they are noted, or they say how a thing is
// known. docs/topology.md has the list.
bool says_nothing_of_topology(const std::string& path) {
    return path.starts_with("/scene/") || path.starts_with("/bounds/") ||
           path == "/frames_per_second" || path.ends_with("/kind_proof") ||
           path.ends_with("/proved_again");
}

// A timeline of less time is true, too, if nothing happens in what it leaves out.
bool says_less(const std::string& path, const Json& value, const Json& other) {
    return other.is_number() &&
           ((path == "/time/0" && other > value) || (path == "/time/1" && other < value));
}

void leave_out_what_follows(Json& json) {
    if (json.is_object()) {
        for (const char* key : {"frame", "frames", "point", "radius", "surface", "complete"})
            json.erase(key);
    }
    if (json.is_structured()) {
        for (Json& child : json) leave_out_what_follows(child);
    }
}

std::vector<Json> other_values(const Json& value) {
    if (value.is_boolean()) return {!value.get<bool>()};
    if (value.is_number_integer()) return {value.get<int>() + 1, value.get<int>() - 1, nullptr};
    if (value.is_number()) return {value.get<double>() + 0.01, value.get<double>() - 0.01, nullptr};
    if (value.is_string()) return {"", "merge", "split", "none", "grows", "shrinks", nullptr};
    return {nullptr, 1};
}

// Every value of the file, whatever it is called: one that is added to the format without being
// compared is found here. With what follows from the rest, and without, as people may write it.
TEST_P(CompleteTimeline, EveryValueOfItsFileIsCompared) {
    const TimelineRecord& truth = GetParam().record;
    if (!is_short(truth)) return; // shorter ones have all of its keys
    for (const bool is_least : {false, true}) {
        Json json = Json::parse(to_json(truth));
        if (is_least) leave_out_what_follows(json);
        ASSERT_TRUE(passes_as_text(json.dump(), truth));
        const Json flat = json.flatten();
        for (const auto& [path, value] : flat.items()) {
            if (says_nothing_of_topology(path)) continue;
            for (const Json& other : other_values(value)) {
                if (other == value || says_less(path, value, other)) continue;
                Json lie = json;
                lie[Json::json_pointer(path)] = other;
                EXPECT_FALSE(passes_as_text(lie.dump(), truth))
                    << "it passes: " << path << " = " << other << " in place of " << value;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(True, CompleteTimeline, testing::ValuesIn(complete_timelines()),
                         [](const auto& timeline) { return timeline.param.name; });

class IncompleteTimeline : public testing::TestWithParam<NamedTimeline> {};

TEST_P(IncompleteTimeline, NeverPassesNorIsPassed) {
    const TimelineRecord& truth = GetParam().record;
    EXPECT_EQ(outcome(truth, truth), Outcome::incomplete);
    for (const Falsehood& lie : falsehoods(GetParam(), 1e-9)) {
        EXPECT_NE(outcome(lie.record, truth), Outcome::passes) << "it passes: " << lie.what;
    }
}

INSTANTIATE_TEST_SUITE_P(True, IncompleteTimeline, testing::ValuesIn(incomplete_timelines()),
                         [](const auto& timeline) { return timeline.param.name; });

// The record as a search of a part of the time would find it.
TimelineRecord part_of(TimelineRecord record, formula::Interval range) {
    Timeline& timeline = record.timeline;
    const Steps steps = steps_of(timeline);
    timeline.start = steps.at(range.lo)->solid;
    timeline.end = steps.at(range.hi)->solid;
    std::erase_if(timeline.events,
                  [&](const Event& event) { return !formula::contains(range, event.time); });
    timeline.range = range;
    return record;
}

TEST(PartOfATimeline, PassesOfTheWholeAndNothingElseDoes) {
    const TimelineRecord whole = story();
    const TimelineRecord part = part_of(whole, {1.5, 4.5}); // frames 16 to 46
    EXPECT_EQ(outcome(part, whole), Outcome::passes);
    for (const Falsehood& lie : falsehoods({"part", part}, 1e-9)) {
        if (lie.what.starts_with("the range")) continue; // that is as true of the whole
        EXPECT_NE(outcome(lie.record, whole), Outcome::passes) << "it passes: " << lie.what;
    }
}

TEST(PartOfATimeline, DoesNotTellOfTheRest) {
    const TimelineRecord whole = story();
    for (const formula::Interval range : {formula::Interval{0, 9.9}, {0.1, 10}, {1.5, 4.5}}) {
        for (const double dt : {1e-9, 0.2, 100.0}) {
            const Check open = check(Expectation(whole), part_of(whole, range), dt);
            EXPECT_NE(open.outcome(), Outcome::passes) << range.lo << " to " << range.hi;
            EXPECT_THAT(open.undecided, testing::Contains(HasSubstr("searched were frames")));
        }
    }
}

// Whatever is expected of a moment within an event's enclosure, it is not known.
TEST(PartOfATimeline, ThatBeginsOrEndsInAnEnclosureIsNotKnown) {
    TimelineRecord whole = story();
    whole.timeline.events[1].time = {1.92, 1.93}; // frames 20.2 to 20.3
    for (const int components : {0, 1, 2, 3}) {
        TimelineRecord part = part_of(whole, {1.94, 4.5});
        part.timeline.range.lo = 1.925;
        part.timeline.start->components = components;
        Check open = check(Expectation(part), whole);
        EXPECT_NE(open.outcome(), Outcome::passes);
        EXPECT_THAT(open.undecided, testing::Contains(HasSubstr("within the enclosure")));
        part = part_of(whole, {0.1, 1.91});
        part.timeline.range.hi = 1.925;
        part.timeline.end->components = components;
        open = check(Expectation(part), whole);
        EXPECT_NE(open.outcome(), Outcome::passes);
        EXPECT_THAT(open.undecided, testing::Contains(HasSubstr("within the enclosure")));
    }
}

TEST(Tolerance, IsOfWhatWasFoundAlone) {
    TimelineRecord lie = story();
    for (auto& box : {&lie.header.start_bounds, &lie.header.end_bounds}) box->fill({-1e12, 1e12});
    lie.timeline.events[0].where[1] = near(0.25);
    EXPECT_EQ(outcome(lie, story()), Outcome::differs);
}

TEST(Tolerance, IsANumberOfSeconds) {
    for (const double dt : {-1e-9, -1.0, double(NAN), double(INFINITY)}) {
        EXPECT_THROW(outcome(story(), story(), dt), std::invalid_argument) << dt;
    }
}

} // namespace
} // namespace isomotion::topology
