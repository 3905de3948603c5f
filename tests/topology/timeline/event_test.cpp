// Kinds of events: names, what each changes, and the table of index and direction.
#include "topology/timeline/event.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "topology/timelines.h"

namespace isomotion::topology::event_test {
namespace {

std::vector<Kind> every_kind() {
    std::vector<Kind> kinds;
    for (int k = int(Kind::unknown); k <= int(Kind::none); ++k) kinds.push_back(Kind(k));
    return kinds;
}

TEST(Kinds, HaveNamesOfTheirOwnThatReadBack) {
    std::set<std::string_view> names;
    for (const Kind kind : every_kind()) {
        EXPECT_TRUE(names.insert(name(kind)).second) << name(kind);
        EXPECT_EQ(parse_kind(name(kind)), kind);
    }
    for (const char* other : {"", "Merge", "merges", "tunnel  forms", "tunnel_forms", " merge"})
        EXPECT_EQ(parse_kind(other), std::nullopt) << other;
}

// A handle of index k adds to b_k or takes from b_(k-1); detached, the reverse.
TEST(Kinds, OfAnIndexAreTheTwoWaysToAttachAHandle) {
    for (int index = 0; index <= 3; ++index) {
        for (const bool grows : {true, false}) {
            std::set<std::array<int, 3>> expected, found;
            const int sign = grows ? 1 : -1;
            for (const int number : {index, index - 1}) {
                // Nothing below b_0, and a solid in space has no b_3.
                if (number < 0 || number > 2) continue;
                std::array<int, 3> betti{};
                betti[std::size_t(number)] = number == index ? sign : -sign;
                expected.insert(betti);
            }
            for (const Kind kind : kinds_of(index, grows)) {
                const Betti add = change(kind);
                found.insert({add.components, add.tunnels, add.voids});
            }
            EXPECT_EQ(found, expected) << "index " << index << (grows ? " grows" : " shrinks");
        }
    }
    EXPECT_TRUE(kinds_of(-1, true).empty());
    EXPECT_TRUE(kinds_of(4, false).empty());
}

// Each but `unknown` and `none` belongs to one index and direction, and its reverse to the other
// direction.
TEST(Kinds, EachHasOneIndexAndDirection) {
    for (const Kind kind : every_kind()) {
        int places = 0, reverses = 0;
        for (int index = 0; index <= 3; ++index) {
            for (const bool grows : {true, false}) {
                const std::vector<Kind> kinds = kinds_of(index, grows);
                if (std::ranges::find(kinds, kind) == kinds.end()) continue;
                ++places;
                for (const Kind other : kinds_of(index, !grows)) {
                    const Betti there = change(kind), back = change(other);
                    reverses += there.components == -back.components &&
                                there.tunnels == -back.tunnels && there.voids == -back.voids;
                }
            }
        }
        const int expected = kind == Kind::unknown || kind == Kind::none ? 0 : 1;
        EXPECT_EQ(places, expected) << name(kind);
        EXPECT_EQ(reverses, expected) << name(kind);
    }
}

TEST(Kinds, OfOneEventChangeTheEulerNumberAlike) {
    for (int index = 0; index <= 3; ++index) {
        for (const bool grows : {true, false}) {
            Event event;
            event.index = index;
            event.grows = grows;
            const int expected = euler_change(event); // of unknown kind
            EXPECT_EQ(std::abs(expected), 1);
            for (const Kind kind : kinds_of(index, grows)) {
                event.kind = kind;
                EXPECT_EQ(euler_change(event), expected);
                EXPECT_EQ(change(kind).euler(), expected) << name(kind);
            }
            event.kind = Kind::none;
            EXPECT_EQ(euler_change(event), 0);
        }
    }
}

TEST(TimelineIsComplete, OnlyWhenNothingIsLeftOpen) {
    ASSERT_TRUE(story().timeline.is_complete());
    ASSERT_TRUE(complete({0, 0, 0}, {}).timeline.is_complete());
    const std::vector<void (*)(Timeline&)> spoilers{
        [](Timeline& t) { t.is_proved = false; },
        [](Timeline& t) { t.events[2].is_proved = false; },
        [](Timeline& t) { t.events.back().kind = Kind::unknown; },
        [](Timeline& t) { t.unresolved.emplace_back(); },
        [](Timeline& t) { t.doubts.emplace_back(); },
        [](Timeline& t) { t.start.reset(); },
        [](Timeline& t) { t.end.reset(); },
        [](Timeline& t) { t.start_is_proved = false; },
        [](Timeline& t) { t.end_is_proved = false; },
    };
    for (std::size_t k = 0; k < spoilers.size(); ++k) {
        Timeline timeline = story().timeline;
        spoilers[k](timeline);
        EXPECT_FALSE(timeline.is_complete()) << k;
    }
    // On the bounds an event may leave the solid as it is; a second proof is nobody's duty.
    Timeline timeline = story().timeline;
    timeline.events[1].kind = Kind::none;
    timeline.events[1].is_proved_again = true;
    EXPECT_TRUE(timeline.is_complete());
}

} // namespace
} // namespace isomotion::topology::event_test
