// Scenes written as text, and their events.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "topology/scenes.h"
#include "topology/search/critical.h"

namespace isomotion::topology {

struct Moving {
    std::string formula;
    std::string bounds;     // TOML: "{ sphere = 2 }"
    std::string parameters; // lines of TOML
    std::string rest = "";  // more tables

    scene::Scene scene() const {
        return scene_of(
            fmt::format("[surface]\nformula = \"{}\"\nbounds = {}\n[parameters]\n{}\n{}\n", formula,
                        bounds, parameters, rest));
    }
};

inline Timeline events_of(const Moving& moving, double from, double to, Side side = Side::negative,
                          const EventSearchOptions& how = {}) {
    return find_events(moving.scene(), side, {from, to}, how);
}

inline double middle(const formula::Interval& a) { return a.lo + (a.hi - a.lo) / 2; }

// What is expected of a group of events at one time.
struct Group {
    double time;
    int count, index;
    bool grows;
};

inline void PrintTo(const Event& event, std::ostream* out) {
    *out << fmt::format(
        "t [{:.17g}, {:.17g}] at ({:.6g}, {:.6g}, {:.6g}) stratum {} index {} {} {}", event.time.lo,
        event.time.hi, middle(event.where[0]), middle(event.where[1]), middle(event.where[2]),
        event.stratum, event.index, event.grows ? "grows" : "shrinks", name(event.kind));
}

inline std::string described(const Timeline& timeline) {
    std::string text;
    for (const Event& event : timeline.events) text += testing::PrintToString(event) + "\n";
    for (const Unresolved& place : timeline.unresolved) {
        text += fmt::format("unresolved t [{:.9g}, {:.9g}] at ([{:.6g}, {:.6g}], [{:.6g}, {:.6g}], "
                            "[{:.6g}, {:.6g}]): {}\n",
                            place.time.lo, place.time.hi, place.where[0].lo, place.where[0].hi,
                            place.where[1].lo, place.where[1].hi, place.where[2].lo,
                            place.where[2].hi, place.why);
    }
    for (const std::string& doubt : timeline.doubts) text += "doubt: " + doubt + "\n";
    return text;
}

// All events and no others, each exactly where it should be. Those that leave the solid as it is
// don't count.
inline void expect_events(const Timeline& timeline, const std::vector<Group>& groups) {
    SCOPED_TRACE(timeline.events.size() < 60 ? described(timeline) : "many");
    EXPECT_TRUE(timeline.is_proved);
    EXPECT_TRUE(timeline.unresolved.empty());
    EXPECT_TRUE(timeline.doubts.empty());
    std::vector<Event> events = timeline.events;
    std::erase_if(events, [](const Event& event) { return event.kind == Kind::none; });
    std::size_t next = 0;
    for (const Group& group : groups) {
        for (int k = 0; k < group.count; ++k, ++next) {
            if (next >= events.size()) {
                ADD_FAILURE() << "only " << events.size() << " events";
                return;
            }
            const Event& event = events[next];
            // The expectation itself is a double.
            const double rounding = 4e-16 * std::abs(group.time);
            EXPECT_LE(event.time.lo, group.time + rounding);
            EXPECT_GE(event.time.hi, group.time - rounding);
            EXPECT_NEAR(middle(event.time), group.time, 1e-12);
            EXPECT_LE(event.time.hi - event.time.lo, 1e-12);
            EXPECT_EQ(event.index, group.index);
            EXPECT_EQ(event.grows, group.grows);
            EXPECT_TRUE(event.is_proved);
            const std::vector<Kind> kinds = kinds_of(group.index, group.grows);
            EXPECT_EQ(event.kind, kinds.size() == 1 ? kinds[0] : Kind::unknown);
        }
    }
    EXPECT_EQ(next, events.size());
}

} // namespace isomotion::topology
