// The attack on claims: of everything that can be claimed of a true timeline each thing is made
// wrong in turn, and nothing wrong passes.
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "topology/timeline/expectation.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/true_timelines.h"
#include "topology/timeline/words.h"
#include "topology/timelines.h"

namespace isomotion::topology::falsified_claims_test {
namespace {

using formula::Interval;

struct NumberName {
    const char* name;
    int Betti::*number;
};
constexpr NumberName numbers[] = {
    {"components", &Betti::components}, {"tunnels", &Betti::tunnels}, {"voids", &Betti::voids}};

// A claim by itself, as both kinds of files hold it.
std::string json_of(const std::string& number, const std::string& frames, int value) {
    return fmt::format(R"({{"{}": {{"{}": {}}}}})", number, frames, value);
}
std::string toml_of(const std::string& number, const std::string& frames, int value) {
    return fmt::format("{} = {{ \"{}\" = {} }}\n", number, frames, value);
}
std::string events_of(const std::vector<std::string>& statements) {
    return fmt::format("[\"{}\"]", fmt::join(statements, "\", \""));
}

bool passes(const std::string& json, const std::string& toml, const TimelineRecord& found) {
    const auto outcome = [&](const std::string& text, const char* file) {
        return check(parse_claims(text, file, found.header.fps), found).outcome();
    };
    const Outcome of_json = outcome(json, "claims.json"), of_toml = outcome(toml, "claims.toml");
    EXPECT_EQ(of_json, of_toml) << json;
    return of_json == Outcome::passes;
}
bool passes(const std::vector<std::string>& statements, const TimelineRecord& found) {
    const std::string events = events_of(statements);
    return passes("{\"events\": " + events + "}", "events = " + events, found);
}

// What happens of one kind between two quiet times: all that can be said of an event in words.
struct Happening {
    int number = 0;
    Kind kind = Kind::unknown;
    Interval frames;    // from the quiet time before to the one after
    Interval quiet;     // in which nothing happens; empty if there is no such time about it
    Interval enclosure; // of the first of them

    std::string text(int said, Kind said_kind, Interval said_frames) const {
        return fmt::format("{} {} between frames {:.9f} and {:.9f}", said,
                           said == 1 ? std::string(name(said_kind)) : plural(said_kind),
                           said_frames.lo, said_frames.hi);
    }
    std::string text() const { return text(number, kind, frames); }
};

class Claimed : public testing::TestWithParam<NamedTimeline> {
protected:
    Claimed()
        : truth_(GetParam().record)
        , steps_(steps_of(truth_.timeline))
        , first_(frame(truth_.timeline.range.lo))
        , last_(frame(truth_.timeline.range.hi)) {}

    double frame(double time) const { return frame_at(truth_.header.fps, time); }
    // Wide enough that frames in it can be written with few digits.
    double frames_of(const Step& step) const { return frame(step.time.hi) - frame(step.time.lo); }
    bool is_quiet(const Step& step) const { return frames_of(step) > 2e-5; }
    double middle(const Step& step) const {
        return 0.5 * (frame(step.time.lo) + frame(step.time.hi));
    }
    int number_of(Kind kind) const {
        return int(std::ranges::count(truth_.timeline.events, kind, &Event::kind));
    }
    // Whether each event of a kind, or each of all, is in what was searched for certain.
    bool is_inside(std::optional<Kind> kind) const {
        return std::ranges::all_of(truth_.timeline.events, [&](const Event& event) {
            return (kind && event.kind != *kind) ||
                   formula::contains(truth_.timeline.range, event.time);
        });
    }

    std::vector<Happening> happenings() const {
        std::vector<Happening> all;
        const auto& instants = steps_.instants;
        for (std::size_t begin = 0, end = 1; begin < instants.size(); begin = end, ++end) {
            // Instants with no quiet time between them are told of together.
            while (end < instants.size() && !is_quiet(steps_.steps[end])) ++end;
            const Step &before = steps_.steps[begin], &after = steps_.steps[end];
            const Interval about{is_quiet(before) ? middle(before) : first_,
                                 is_quiet(after) ? middle(after) : last_};
            Interval quiet = Interval(1, 0);
            if (is_quiet(after)) {
                quiet = {middle(after), frame(after.time.hi) - 0.1 * frames_of(after)};
            } else if (is_quiet(before)) {
                quiet = {frame(before.time.lo) + 0.1 * frames_of(before), middle(before)};
            }
            std::map<Kind, std::vector<std::size_t>> instants_of; // an entry for each event
            for (std::size_t k = begin; k < end; ++k) {
                for (const std::size_t event : instants[k].events)
                    instants_of[truth_.timeline.events[event].kind].push_back(k);
            }
            for (const auto& [kind, of] : instants_of) {
                all.push_back({int(of.size()), kind, about, quiet,
                               frames_at(truth_.header.fps, instants[of.front()].time)});
            }
        }
        return all;
    }

    void expect_false(const std::string& statement) {
        EXPECT_FALSE(passes({statement}, truth_)) << "it passes: " << statement;
        ++falsified_;
    }
    void expect_true(const std::string& statement) {
        EXPECT_TRUE(passes({statement}, truth_)) << "it does not pass: " << statement;
    }

    const TimelineRecord& truth_;
    const Steps steps_;
    const double first_, last_; // frames
    int falsified_ = 0;
};

TEST_P(Claimed, BettiNumbers) {
    for (const Step& step : steps_.steps) {
        if (!is_quiet(step)) continue;
        const double lo = frame(step.time.lo), hi = frame(step.time.hi);
        const std::string moment = fmt::format("{:.9f}", middle(step));
        const std::string span =
            fmt::format("{:.9f}..{:.9f}", lo + 0.1 * (hi - lo), hi - 0.1 * (hi - lo));
        for (const auto& [name, number] : numbers) {
            const int value = (*step.solid).*number;
            for (const std::string& frames : {moment, span}) {
                for (const int said : {value, value - 1, value + 1, value + 100}) {
                    if (said < 0) continue;
                    EXPECT_EQ(
                        passes(json_of(name, frames, said), toml_of(name, frames, said), truth_),
                        said == value)
                        << name << " at " << frames << ": " << said << " in place of " << value;
                }
            }
        }
    }
}

// At an event's own time, across one that changes the number, and where nobody searched.
TEST_P(Claimed, NumbersThatAreNotKnown) {
    std::vector<std::string> unknown = {
        fmt::format("{:.6f}", first_ - 1e-6), fmt::format("{:.6f}", last_ + 1e-6),
        fmt::format("{:.6f}..{:.6f}", first_ - 0.25, 0.5 * (first_ + last_)),
        fmt::format("{:.6f}..{:.6f}", first_, last_ + 1e-6)};
    for (const Instant& instant : steps_.instants) {
        unknown.push_back(fmt::format("{:.17f}", frame(mid(instant.time))));
    }
    for (const auto& [name, number] : numbers) {
        for (const std::string& frames : unknown) {
            for (int value = 0; value < 6; ++value) {
                EXPECT_FALSE(
                    passes(json_of(name, frames, value), toml_of(name, frames, value), truth_))
                    << "it passes: " << name << " at " << frames << " = " << value;
            }
        }
        for (std::size_t k = 0; k < steps_.instants.size(); ++k) {
            const Step &before = steps_.steps[k], &next = steps_.steps[k + 1];
            const int value = (*before.solid).*number, other = (*next.solid).*number;
            if (value == other || !is_quiet(before) || !is_quiet(next)) continue;
            const std::string across = fmt::format("{:.9f}..{:.9f}", middle(before), middle(next));
            for (const int said : {value, other}) {
                EXPECT_FALSE(
                    passes(json_of(name, across, said), toml_of(name, across, said), truth_))
                    << "it passes: " << name << " at " << across << " = " << said;
            }
        }
    }
}

TEST_P(Claimed, EachEvent) {
    const auto all = happenings();
    for (const Happening& each : all) {
        expect_true(each.text());
        for (const int number : {each.number - 1, each.number + 1, 0, 100}) {
            if (number >= 0) expect_false(each.text(number, each.kind, each.frames));
        }
        for (int kind = int(Kind::birth); kind < int(Kind::none); ++kind) {
            const bool is_said = std::ranges::any_of(all, [&](const Happening& other) {
                return other.kind == Kind(kind) && other.number == each.number &&
                       other.frames == each.frames;
            });
            if (!is_said) expect_false(each.text(each.number, Kind(kind), each.frames));
        }
        // At another time, or at a time that was not searched, in part or all of it.
        if (!is_empty(each.quiet)) expect_false(each.text(each.number, each.kind, each.quiet));
        expect_false(each.text(each.number, each.kind, {first_ - 0.5, each.frames.hi}));
        expect_false(each.text(each.number, each.kind, {each.frames.lo, last_ + 1e-6}));
        expect_false(each.text(each.number, each.kind, {last_ + 1, last_ + 2}));
        // Whether it is before or after the middle of its enclosure is not known.
        const double middle = mid(each.enclosure);
        for (const int number : {0, each.number}) {
            expect_false(
                fmt::format("{} {} before frame {:.17f}", number, name(each.kind), middle));
            expect_false(fmt::format("{} {} after frame {:.17f}", number, name(each.kind), middle));
        }
    }
    RecordProperty("falsified", falsified_);
}

TEST_P(Claimed, HowManyThereAreOfEachKind) {
    // If some events may be outside, how many there are is not known.
    const auto expect_known = [&](const std::string& statement, std::optional<Kind> kind) {
        is_inside(kind) ? expect_true(statement) : expect_false(statement);
    };
    int events = 0;
    for (int k = int(Kind::birth); k < int(Kind::none); ++k) {
        const std::string kinds = plural(Kind(k));
        const int number = number_of(Kind(k));
        events += number;
        for (const int said : {number, number - 1, number + 1, 100 + number}) {
            if (said < 0) continue;
            const std::string statement = fmt::format("{} {}", said, kinds);
            said == number ? expect_known(statement, Kind(k)) : expect_false(statement);
        }
        expect_known(fmt::format("at least {} {}", number, kinds), Kind(k));
        expect_true(fmt::format("at most {} {}", number, kinds));
        expect_false(fmt::format("at least {} {}", number + 1, kinds));
        if (number > 0) {
            expect_false(fmt::format("at most {} {}", number - 1, kinds));
            expect_false("no " + kinds);
        }
        // As true as it may be, nobody looked there.
        for (const std::string& when :
             {fmt::format("at frame {:.0f}", first_), fmt::format("at frame {:.0f}", last_),
              fmt::format("at frame {:.0f}", last_ + 10),
              fmt::format("between frames {:.6f} and {:.6f}", first_ - 1e-6, first_ + 1e-3),
              fmt::format("at frame {:.6f}..{:.6f}", last_ - 1e-3, last_ + 1e-6),
              fmt::format("before frame {:.6f}", first_), fmt::format("after frame {:.6f}", last_),
              fmt::format("before frame {:.6f}", last_ + 0.5),
              fmt::format("after frame {:.6f}", first_ - 0.5)}) {
            expect_false(fmt::format("no {} {}", kinds, when));
        }
    }
    expect_known(fmt::format("{} events", events), {});
    expect_false(fmt::format("{} events", events + 1));
    if (events > 0) {
        expect_false(fmt::format("{} events", events - 1));
        expect_false("no events");
        expect_false("nothing else");
    }
    RecordProperty("falsified", falsified_);
}

TEST_P(Claimed, NothingElse) {
    std::vector<std::string> statements = {"nothing else"};
    const auto all = happenings();
    for (const Happening& each : all) statements.push_back(each.text());
    EXPECT_TRUE(passes(statements, truth_));
    for (std::size_t k = 0; k < all.size(); k += GetParam().every) {
        auto fewer = statements;
        fewer.erase(fewer.begin() + std::ptrdiff_t(k) + 1);
        EXPECT_FALSE(passes(fewer, truth_)) << "it passes without " << all[k].text();
        auto other = statements;
        const Kind kind = all[k].kind == Kind::birth ? Kind::death : Kind::birth;
        other[k + 1] = "at most 1000 " + all[k].text(0, kind, all[k].frames).substr(2);
        EXPECT_FALSE(passes(other, truth_)) << "it passes with " << other[k + 1];
        auto more = statements;
        more.push_back("1000 events");
        EXPECT_FALSE(passes(more, truth_));
    }
}

INSTANTIATE_TEST_SUITE_P(True, Claimed, testing::ValuesIn([] {
                             auto all = complete_timelines();
                             // Between two events that may both be outside no number is proved.
                             std::erase_if(all, [](const NamedTimeline& each) {
                                 return each.name == "at_both_ends";
                             });
                             return all;
                         }()),
                         [](const auto& timeline) { return timeline.param.name; });

// With a gap in what is known, claims of numbers and counts of the whole never pass.
class ClaimedOfTheIncomplete : public testing::TestWithParam<NamedTimeline> {};

TEST_P(ClaimedOfTheIncomplete, NoFalseStatementPasses) {
    const TimelineRecord& found = GetParam().record;
    for (int k = int(Kind::birth); k < int(Kind::none); ++k) {
        const auto number = std::ranges::count(story().timeline.events, Kind(k), &Event::kind);
        for (const auto said : {number + 1, number + 100}) {
            for (const char* how : {"", "at least "}) {
                const std::string statement = fmt::format("{}{} {}", how, said, plural(Kind(k)));
                EXPECT_FALSE(passes({statement}, found)) << "it passes: " << statement;
            }
        }
    }
    EXPECT_FALSE(passes({"nothing else"}, found));
    EXPECT_FALSE(passes({"5 events"}, found));
    for (const auto& [name, number] : numbers) {
        for (const char* frames : {"1", "15", "30..35", "60", "101", "1..101"}) {
            EXPECT_FALSE(passes(json_of(name, frames, 7), toml_of(name, frames, 7), found))
                << "it passes: " << name << " at " << frames;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(True, ClaimedOfTheIncomplete, testing::ValuesIn(incomplete_timelines()),
                         [](const auto& timeline) { return timeline.param.name; });

} // namespace
} // namespace isomotion::topology::falsified_claims_test
