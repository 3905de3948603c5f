// Whole timelines as a person tells them.
#pragma once

#include <string>
#include <vector>

#include "topology/analyse.h"
#include "topology/moving.h"

namespace isomotion::topology {

inline const std::string in_a_second = "[time]\nfps = 10\nframes = 11\n";

struct Told {
    double time;
    Kind kind;
};

inline std::vector<Event> that_change(const Timeline& timeline) {
    std::vector<Event> events = timeline.events;
    std::erase_if(events, [](const Event& event) { return event.kind == Kind::none; });
    return events;
}

// These events that change the solid and no others, and all is proved.
inline Timeline expect_timeline(const Moving& moving, const Betti& start,
                                const std::vector<Told>& told, const Betti& end) {
    SCOPED_TRACE(moving.formula);
    Timeline timeline = analyse(moving.scene());
    SCOPED_TRACE(described(timeline));
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_EQ(timeline.start, start);
    EXPECT_EQ(timeline.end, end);
    const std::vector<Event> events = that_change(timeline);
    EXPECT_EQ(events.size(), told.size());
    for (std::size_t k = 0; k < std::min(events.size(), told.size()); ++k) {
        EXPECT_NEAR(middle(events[k].time), told[k].time, 1e-12);
        EXPECT_EQ(events[k].kind, told[k].kind);
        EXPECT_TRUE(events[k].is_proved);
    }
    return timeline;
}

} // namespace isomotion::topology
