// Kinds of events: paths and counting on closed forms, and what fails to agree.
#include "topology/classify/kinds.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "topology/moving_scene.h"
#include "topology/scenes.h"
#include "topology/solids.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// A scene whose parameter c is the time, and its one event.
struct Passing {
    const char* name;
    const char* formula;
    const char* bounds;
    double time;
    std::array<double, 3> where;
    int index;
    bool grows;
    Kind kind;
    bool is_joined;
    int stratum = 3;
};

void PrintTo(const Passing& passing, std::ostream* out) { *out << passing.name; }

// Where slope(x) is 0, near x.
template<class Slope> double root(Slope&& slope, double low, double high) {
    for (int k = 0; k < 200; ++k) {
        const double middle = (low + high) / 2;
        ((slope(middle) < 0) == (slope(low) < 0) ? low : high) = middle;
    }
    return low;
}

// x (x^2 - 1) + a = 0 near 1: where (x^2 - 1)^2/4 + a x rests, and what it is there.
const double dent = root([](double x) { return x * (x * x - 1) + 0.05; }, 0.9, 1);
const double dent_value = (dent * dent - 1) * (dent * dent - 1) / 4 + 0.05 * dent;

const Passing passings[] = {
    {"two balls meet",
     "z^4 - 2*z^2 + x^2 + y^2 - c",
     "{ sphere = 2 }",
     0,
     {0, 0, 0},
     1,
     true,
     Kind::merge,
     false},
    {"a ball parts",
     "z^4 - 2*z^2 + x^2 + y^2 + c",
     "{ sphere = 2 }",
     0,
     {0, 0, 0},
     1,
     false,
     Kind::split,
     false},
    {"a ring closes",
     "(x^2 + y^2 - 1)^2/4 + z^2 + 0.05*x - c",
     "{ sphere = 2 }",
     dent_value,
     {dent, 0, 0},
     1,
     true,
     Kind::tunnel_forms,
     true},
    {"a ring opens",
     "(x^2 + y^2 - 1)^2/4 + z^2 + 0.05*x + c",
     "{ sphere = 2 }",
     -dent_value,
     {dent, 0, 0},
     1,
     false,
     Kind::tunnel_breaks,
     true},
    {"the hole of a torus closes",
     "(sqrt(x^2 + y^2 + 0.04) - 0.8)^2 + z^2 - c",
     "{ box = [[-1.7, -1.7, -1], [1.7, 1.7, 1]] }",
     0.36,
     {0, 0, 0},
     2,
     true,
     Kind::tunnel_closes,
     true},
    {"the hole of a torus opens",
     "(sqrt(x^2 + y^2 + 0.04) - 0.8)^2 + z^2 + c",
     "{ sphere = 2 }",
     -0.36,
     {0, 0, 0},
     2,
     false,
     Kind::tunnel_opens,
     true},
    {"a bowl becomes a shell",
     "(x^2 + y^2 + z^2 - 1)^2/4 + 0.05*z - c",
     "{ sphere = 2 }",
     dent_value,
     {0, 0, dent},
     2,
     true,
     Kind::void_forms,
     false},
    {"a shell breaks",
     "(x^2 + y^2 + z^2 - 1)^2/4 + 0.05*z + c",
     "{ sphere = 2 }",
     -dent_value,
     {0, 0, dent},
     2,
     false,
     Kind::void_opens,
     false},
    // Both nappes end at walls, with nothing inside between them.
    {"a box fills",
     "z^2 - x^2 - y^2 + 0.5*(x^4 + y^4) - c",
     "{ box = [[-0.6, -0.6, -0.6], [0.6, 0.6, 0.6]] }",
     0,
     {0, 0, 0},
     2,
     true,
     Kind::tunnel_closes,
     true},
    // On the wall z = 0, which F rises from; the ring is cut in half along.
    {"half a ring closes on a wall",
     "(x^2 + y^2 - 1)^2/4 + 0.1*z + z^2 + 0.05*x - c",
     "{ box = [[-2, -2, 0], [2, 2, 1]] }",
     dent_value,
     {dent, 0, 0},
     1,
     true,
     Kind::tunnel_forms,
     true,
     2},
    // On the sphere's pole, where 1 - z is (x^2 + y^2)/2.
    {"two caps meet on a sphere",
     "1 - z - x^2 + x^4 - c",
     "{ sphere = 1 }",
     0,
     {0, 0, 1},
     1,
     true,
     Kind::merge,
     false,
     2},
    {"a bubble leaves a sphere",
     "0.16 - x^2 - y^2 - (z - 0.6)^2 - c",
     "{ sphere = 1 }",
     0,
     {0, 0, 1},
     2,
     true,
     Kind::void_forms,
     false,
     2},
    {"a groove becomes a hole",
     "0.16 - (x - 0.6)^2 - y^2 - c",
     "{ sphere = 1 }",
     0,
     {1, 0, 0},
     1,
     true,
     Kind::tunnel_forms,
     true,
     2},
};

class Passages : public testing::TestWithParam<Passing> {
protected:
    Passages()
        : scene_(scene_of(fmt::format("[surface]\nformula = '{}'\nbounds = {}\n"
                                      "[parameters]\nc = 't'\n",
                                      GetParam().formula, GetParam().bounds)))
        , range_{GetParam().time - 0.02, GetParam().time + 0.02}
        , frames_(scene_, Side::negative, range_) {}

    Event event() const {
        const Passing& passing = GetParam();
        Event event;
        event.time = {passing.time - 1e-13, passing.time + 1e-13};
        for (std::size_t i = 0; i < 3; ++i)
            event.where[i] = {passing.where[i] - 1e-12, passing.where[i] + 1e-12};
        event.index = passing.index;
        event.grows = passing.grows;
        event.stratum = passing.stratum;
        event.is_proved = true;
        return event;
    }

    scene::Scene scene_;
    Interval range_;
    MovingScene frames_;
};

TEST_P(Passages, SidesAreJoinedOnlyByATunnel) {
    const KindProofs proofs = frames_.proofs({event()});
    for (int effort : {0, 1, 2}) {
        const Sides sides = proofs.paths(std::array{std::size_t(0)}, effort)[0];
        EXPECT_EQ(sides == Sides::joined, GetParam().is_joined) << effort;
        EXPECT_FALSE(sides == Sides::apart && GetParam().is_joined) << effort;
    }
}

TEST_P(Passages, KindIsFound) {
    for (bool with_paths : {true, false}) {
        Timeline timeline;
        timeline.range = range_;
        timeline.events = {event()};
        timeline.start = frames_.certify(range_.lo).betti;
        timeline.end = frames_.certify(range_.hi).betti;
        ASSERT_TRUE(timeline.start && timeline.end);
        timeline.start_is_proved = timeline.end_is_proved = timeline.is_proved = true;
        find_kinds(timeline, with_paths ? frames_.proofs({event()}) : KindProofs{});
        const Event& found = timeline.events[0];
        EXPECT_EQ(found.kind, GetParam().kind) << name(found.kind);
        EXPECT_EQ(found.kind_proof, "frames"); // they cost nothing more, and come first
        EXPECT_EQ(found.before, timeline.start);
        EXPECT_EQ(found.after, timeline.end);
        EXPECT_TRUE(timeline.doubts.empty()) << timeline.doubts[0];
        EXPECT_TRUE(timeline.is_complete());
    }
}

// A path alone tells of a tunnel; that there is none, boxes tell.
TEST_P(Passages, KindIsFoundWithoutFrames) {
    Timeline timeline;
    timeline.range = range_;
    timeline.events = {event()};
    timeline.is_proved = true;
    KindProofs proofs;
    proofs.paths = frames_.proofs({event()}).paths;
    find_kinds(timeline, proofs);
    const Event& found = timeline.events[0];
    EXPECT_EQ(found.kind, GetParam().kind);
    EXPECT_EQ(found.kind_proof, GetParam().is_joined ? "path" : "apart");
}

INSTANTIATE_TEST_SUITE_P(Kinds, Passages, testing::ValuesIn(passings));

Event an_event(double time, int index, bool grows) {
    Event event;
    event.time = {time - 1e-12, time + 1e-12};
    event.index = index;
    event.grows = grows;
    event.is_proved = true;
    return event;
}

Timeline timeline_of(std::vector<Event> events, Betti start, Betti end) {
    Timeline timeline;
    timeline.range = {0, 10};
    timeline.events = std::move(events);
    timeline.start = start;
    timeline.end = end;
    timeline.start_is_proved = timeline.end_is_proved = timeline.is_proved = true;
    return timeline;
}

TEST(Counting, AllAreForced) {
    Timeline timeline =
        timeline_of({an_event(1, 1, true), an_event(2, 1, true)}, {3, 0, 0}, {1, 0, 0});
    find_kinds(timeline, {});
    for (const Event& event : timeline.events) {
        EXPECT_EQ(event.kind, Kind::merge);
        EXPECT_EQ(event.kind_proof, "counting");
    }
    EXPECT_EQ(timeline.events[0].after, (Betti{2, 0, 0}));
    EXPECT_TRUE(timeline.is_complete());
}

TEST(Counting, NoneIsForced) {
    // One of two merges, and it isn't known which.
    Timeline timeline =
        timeline_of({an_event(1, 1, true), an_event(2, 1, true)}, {2, 0, 0}, {1, 1, 0});
    find_kinds(timeline, {});
    EXPECT_EQ(timeline.events[0].kind, Kind::unknown);
    EXPECT_EQ(timeline.events[1].kind, Kind::unknown);
    EXPECT_EQ(timeline.events[0].before, (Betti{2, 0, 0}));
    EXPECT_FALSE(timeline.events[0].after);
    EXPECT_EQ(timeline.events[1].after, (Betti{1, 1, 0}));
    EXPECT_TRUE(timeline.doubts.empty());
    EXPECT_FALSE(timeline.is_complete());
}

// Merge and split leave no trace in the ends; a frame between them tells.
TEST(Counting, FramesBetween) {
    const std::vector<Event> events{an_event(1, 1, true), an_event(2, 1, true),
                                    an_event(7, 1, false), an_event(8, 1, false)};
    Timeline timeline = timeline_of(events, {3, 0, 0}, {3, 0, 0});
    find_kinds(timeline, {});
    EXPECT_EQ(timeline.events[0].kind, Kind::unknown);

    timeline = timeline_of(events, {3, 0, 0}, {3, 0, 0});
    int asked = 0;
    KindProofs proofs;
    proofs.frame = [&](double time) {
        ++asked;
        EXPECT_TRUE(2 < time && time < 7) << time;
        return std::optional(Betti{1, 0, 0});
    };
    find_kinds(timeline, proofs);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(timeline.events[0].kind, Kind::merge);
    EXPECT_EQ(timeline.events[3].kind, Kind::split);
    EXPECT_TRUE(timeline.is_complete());
}

// The last of three by the middles of their times may come right after the first.
TEST(Counting, FramesAreAskedForWhereNoEventMayBe) {
    std::vector<Event> events{an_event(1, 1, true), an_event(2, 1, false), an_event(2.1, 1, true),
                              an_event(8, 1, false)};
    events[2].time = {1.4, 2.8};
    Timeline timeline = timeline_of(events, {3, 0, 0}, {3, 0, 0});
    KindProofs proofs;
    int asked = 0;
    proofs.frame = [&](double time) -> std::optional<Betti> {
        ++asked;
        for (const Event& event : events) EXPECT_FALSE(contains(event.time, time)) << time;
        return std::nullopt;
    };
    find_kinds(timeline, proofs);
    EXPECT_GT(asked, 0);
}

TEST(Counting, EventsAtOneTime) {
    // Twelve necks form at once between eight blobs: seven merge, five make tunnels.
    const auto count = [](const Timeline& timeline, Kind kind) {
        return std::ranges::count(timeline.events, kind, &Event::kind);
    };
    std::vector<Event> events(12, an_event(5, 1, true));
    Timeline timeline = timeline_of(events, {8, 0, 0}, {1, 5, 0});
    find_kinds(timeline, {});
    EXPECT_EQ(count(timeline, Kind::merge), 7);
    EXPECT_EQ(count(timeline, Kind::tunnel_forms), 5);
    EXPECT_TRUE(timeline.is_complete());
    for (const Event& event : timeline.events) EXPECT_EQ(event.kind_proof, "together");

    // Six holes in the faces close at once: a void forms, five tunnels close.
    events.assign(6, an_event(5, 2, true));
    timeline = timeline_of(events, {1, 5, 0}, {1, 0, 1});
    find_kinds(timeline, {});
    EXPECT_EQ(count(timeline, Kind::void_forms), 1);
    EXPECT_EQ(count(timeline, Kind::tunnel_closes), 5);
    EXPECT_TRUE(timeline.is_complete());

    // So too if something else happens at another time.
    events.assign(6, an_event(5, 2, false));
    events.insert(events.begin(), an_event(3, 3, false));
    timeline = timeline_of(events, {1, 0, 0}, {1, 5, 0});
    find_kinds(timeline, {});
    EXPECT_EQ(count(timeline, Kind::void_born), 1);
    EXPECT_EQ(count(timeline, Kind::void_opens), 1);
    EXPECT_EQ(count(timeline, Kind::tunnel_opens), 5);
    EXPECT_TRUE(timeline.is_complete());

    // Two of three are known to come one after another: that the first overlaps both isn't enough.
    events.assign(3, an_event(5, 1, true));
    events[0].time = {1, 3};
    events[1].time = {1.5, 1.6};
    events[2].time = {2.8, 2.9};
    timeline = timeline_of(events, {2, 0, 0}, {1, 2, 0});
    find_kinds(timeline, {});
    EXPECT_EQ(count(timeline, Kind::unknown), 3);
    EXPECT_FALSE(timeline.is_complete());
    // All three are merges, whenever they come: but no frames about one moment say so.
    timeline = timeline_of(events, {4, 0, 0}, {1, 0, 0});
    find_kinds(timeline, {});
    for (const Event& event : timeline.events) EXPECT_EQ(event.kind_proof, "counting");

    // Some grow and some shrink: nothing tells how many.
    events = {an_event(5, 1, true), an_event(5, 1, false)};
    timeline = timeline_of(events, {2, 1, 0}, {2, 1, 0});
    find_kinds(timeline, {});
    EXPECT_EQ(count(timeline, Kind::unknown), 2);
    EXPECT_TRUE(timeline.doubts.empty());
}

TEST(Counting, WhatCannotBeIsDoubted) {
    // An event too few for the ends, Betti numbers below 0, an end that doesn't follow.
    Timeline missing = timeline_of({an_event(1, 1, true)}, {3, 0, 0}, {1, 0, 0});
    find_kinds(missing, {});
    EXPECT_FALSE(missing.doubts.empty());

    Timeline impossible =
        timeline_of({an_event(1, 0, false), an_event(2, 0, true)}, {0, 0, 0}, {0, 0, 0});
    find_kinds(impossible, {});
    EXPECT_FALSE(impossible.doubts.empty());

    Timeline wrong = timeline_of({an_event(1, 0, true)}, {1, 0, 0}, {1, 0, 1});
    find_kinds(wrong, {});
    EXPECT_FALSE(wrong.doubts.empty());

    for (const Timeline& timeline : {missing, impossible, wrong})
        EXPECT_FALSE(timeline.is_complete());
}

// Where events may be missing kinds are not counted; that one is missing shows all the same.
TEST(Counting, TheEulerNumberTellsWhateverTheKinds) {
    for (const int components : {2, 3}) {
        Timeline timeline = timeline_of({an_event(1, 1, true)}, {3, 0, 0}, {components, 0, 0});
        timeline.is_proved = false;
        timeline.doubts = {"found from seeds"};
        find_kinds(timeline, {});
        EXPECT_EQ(timeline.events[0].kind, Kind::unknown);
        EXPECT_EQ(timeline.doubts.size(), components == 2 ? 1u : 2u);
    }
}

TEST(Counting, MoreThanTheEventsCanAddIsRefused) {
    std::vector<Event> events{an_event(1, 1, true)};
    EXPECT_TRUE(count_kinds(events, {3, 0, 0}, {2, 0, 0}));
    EXPECT_EQ(events[0].kind, Kind::merge);
    for (const int components : {1, 4}) {
        events = {an_event(1, 1, true)};
        EXPECT_FALSE(count_kinds(events, {3, 0, 0}, {components, 0, 0})) << components;
        EXPECT_EQ(events[0].kind, Kind::unknown) << components;
    }
}

TEST(Counting, NotAcrossDegeneratePlaces) {
    const std::vector<Event> events{an_event(1, 1, true), an_event(9, 1, true)};
    Timeline timeline = timeline_of(events, {3, 0, 0}, {1, 0, 0});
    timeline.unresolved.push_back({{4.9, 5.1}, {}, "degenerate", {}, {}});
    timeline.is_proved = false;
    find_kinds(timeline, {});
    EXPECT_EQ(timeline.events[0].kind, Kind::unknown);

    timeline = timeline_of(events, {3, 0, 0}, {1, 0, 0});
    timeline.unresolved.push_back({{4.9, 5.1}, {}, "degenerate", {}, {}});
    timeline.is_proved = false;
    KindProofs proofs;
    proofs.frame = [](double time) { return Betti{2, 0, time < 5 ? 0 : 1}; };
    find_kinds(timeline, proofs);
    EXPECT_EQ(timeline.events[0].kind, Kind::merge);
    EXPECT_EQ(timeline.unresolved[0].before, (Betti{2, 0, 0}));
    EXPECT_EQ(timeline.unresolved[0].after, (Betti{2, 0, 1}));
}

// An end whose own frame has no proof has that of a quiet time.
TEST(Counting, EndsHaveTheirProofElsewhere) {
    const std::vector<Event> events{an_event(4, 1, true), an_event(6, 1, true)};
    Timeline timeline = timeline_of(events, {}, {});
    timeline.start = timeline.end = std::nullopt;
    timeline.start_is_proved = timeline.end_is_proved = false;
    KindProofs proofs;
    proofs.frame = [](double time) -> std::optional<Betti> {
        EXPECT_TRUE(time < 4 || time > 6) << time;
        if (time > 1 && time < 4) return std::nullopt;
        return Betti{time < 4 ? 3 : 1, 0, 0};
    };
    Timeline missing = timeline;
    find_kinds(timeline, proofs);
    EXPECT_EQ(timeline.start, (Betti{3, 0, 0}));
    EXPECT_EQ(timeline.end, (Betti{1, 0, 0}));
    EXPECT_EQ(timeline.events[0].kind, Kind::merge);
    EXPECT_TRUE(timeline.is_complete());

    // Not where events may be missing.
    missing.is_proved = false;
    missing.doubts = {"interrupted"};
    find_kinds(missing, proofs);
    EXPECT_FALSE(missing.start_is_proved);
    EXPECT_FALSE(missing.is_complete());
}

// Where no quiet time beside an end has a frame either, proved events lead there from a frame
// between others.
TEST(Counting, EndsFollowFromAFrameBetweenEvents) {
    const std::vector<Event> events{an_event(1, 0, true), an_event(2, 3, true),
                                    an_event(8, 0, false), an_event(9, 0, true)};
    Timeline timeline = timeline_of(events, {}, {});
    timeline.start = timeline.end = std::nullopt;
    timeline.start_is_proved = timeline.end_is_proved = false;
    KindProofs proofs;
    proofs.frame = [](double time) -> std::optional<Betti> {
        if (time < 2 || time > 8) return std::nullopt;
        return Betti{3, 0, 0};
    };
    const Timeline open = timeline;
    find_kinds(timeline, proofs);
    EXPECT_EQ(timeline.start, (Betti{2, 0, 1}));
    EXPECT_EQ(timeline.end, (Betti{3, 0, 0}));
    EXPECT_TRUE(timeline.is_complete());

    // Not over an event of unknown kind, over a degenerate place, nor where events may be missing.
    Timeline unknown = open;
    unknown.events[0] = an_event(1, 1, true);
    find_kinds(unknown, proofs);
    EXPECT_FALSE(unknown.start_is_proved);
    EXPECT_TRUE(unknown.end_is_proved);
    Timeline degenerate = open;
    degenerate.is_proved = false;
    degenerate.unresolved.push_back({{0.4, 0.6}, {}, "degenerate", {}, {}});
    find_kinds(degenerate, proofs);
    EXPECT_FALSE(degenerate.start_is_proved);
    EXPECT_TRUE(degenerate.end_is_proved);
    Timeline missing = open;
    missing.is_proved = false;
    find_kinds(missing, proofs);
    EXPECT_FALSE(missing.start_is_proved || missing.end_is_proved);
    Timeline guessed = open;
    guessed.events[3].is_proved = false;
    find_kinds(guessed, proofs);
    EXPECT_FALSE(guessed.start_is_proved || guessed.end_is_proved);
}

// Frames beyond another degenerate place tell nothing of this one.
TEST(Counting, NothingIsKnownBetweenDegeneratePlaces) {
    Timeline timeline = timeline_of({}, {1, 1, 0}, {1, 1, 0});
    timeline.unresolved.push_back({{2.9, 3.1}, {}, "degenerate", {}, {}});
    timeline.unresolved.push_back({{6.9, 7.1}, {}, "degenerate", {}, {}});
    timeline.is_proved = false;
    find_kinds(timeline, {});
    EXPECT_EQ(timeline.unresolved[0].before, timeline.start);
    EXPECT_EQ(timeline.unresolved[0].after, std::nullopt);
    EXPECT_EQ(timeline.unresolved[1].before, std::nullopt);
    EXPECT_EQ(timeline.unresolved[1].after, timeline.end);
}

// Nor of events beyond one, from the only end that is known.
TEST(Counting, NumbersEndAtDegeneratePlaces) {
    for (const bool from_start : {true, false}) {
        Timeline timeline =
            timeline_of({an_event(1, 0, true), an_event(9, 0, true)}, {1, 0, 0}, {7, 0, 0});
        (from_start ? timeline.end : timeline.start) = std::nullopt;
        timeline.unresolved.push_back({{4.9, 5.1}, {}, "degenerate", {}, {}});
        timeline.is_proved = false;
        find_kinds(timeline, {});
        const auto& [first, last] = std::tie(timeline.events[0], timeline.events[1]);
        EXPECT_EQ(first.after.has_value(), from_start);
        EXPECT_EQ(last.before.has_value(), !from_start);
    }
}

// Random histories: what is found is what happened, and nothing is doubted.
TEST(Counting, RandomHistories) {
    int counted = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        formula::Random random(seed);
        Betti now{1 + random.below(3), random.below(3), random.below(2)};
        const Betti start = now;
        std::vector<Event> events;
        std::vector<Kind> kinds;
        std::vector<Betti> bettis{now};
        for (double time = 0.5; time < 9.5; time += random.in(0.1, 2)) {
            const int index = random.below(4);
            const bool grows = random.below(2);
            const auto possible = kinds_of(index, grows);
            const Kind kind = possible[std::size_t(random.below(int(possible.size())))];
            const Betti by = change(kind);
            const Betti next{now.components + by.components, now.tunnels + by.tunnels,
                             now.voids + by.voids};
            if (!next.is_possible()) continue;
            now = next;
            events.push_back(an_event(time, index, grows));
            kinds.push_back(kind);
            bettis.push_back(now);
        }
        for (bool with_frames : {false, true}) {
            Timeline timeline = timeline_of(events, start, now);
            KindProofs proofs;
            if (with_frames) {
                proofs.frame = [&](double time) {
                    std::size_t k = 0;
                    while (k < events.size() && events[k].time.hi < time) ++k;
                    return std::optional(bettis[k]);
                };
            }
            find_kinds(timeline, proofs);
            EXPECT_TRUE(timeline.doubts.empty()) << "seed " << seed << ": " << timeline.doubts[0];
            for (std::size_t k = 0; k < events.size(); ++k) {
                const Event& event = timeline.events[k];
                if (event.kind == Kind::unknown) {
                    EXPECT_FALSE(with_frames) << "seed " << seed;
                    continue;
                }
                counted += !with_frames && event.kind_proof == "counting";
                EXPECT_EQ(event.kind, kinds[k]) << "seed " << seed << ", event " << k;
                if (event.before) {
                    EXPECT_EQ(*event.before, bettis[k]) << "seed " << seed;
                }
                if (event.after) {
                    EXPECT_EQ(*event.after, bettis[k + 1]) << "seed " << seed;
                }
            }
        }
    }
    EXPECT_GT(counted, 100);
}

} // namespace
} // namespace isomotion::topology
