// Timelines made by hand and at random, for tests of what is done with them.
#pragma once

#include <random>

#include "topology/timeline/steps.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// Frames are tenths of seconds: frame 12 is 1.1 s.
inline TimelineHeader ten_a_second() {
    TimelineHeader header;
    header.title = "A <made> & timed \"scene\"";
    header.fingerprint = "0123456789abcdef0123456789abcdef";
    header.fps = {10, 1};
    header.start_bounds.fill({-1, 1});
    header.end_bounds.fill({-1, 1});
    return header;
}

// Times and places as narrow as a proof leaves them.
inline formula::Interval near(double value) { return {value - 2e-14, value + 2e-14}; }

inline Event event_at(double frame, Kind kind, std::array<double, 3> where = {}) {
    Event event;
    event.time = near((frame - 1) / 10);
    for (std::size_t k = 0; k < 3; ++k) event.where[k] = near(where[k]);
    event.kind = kind;
    event.is_proved = true;
    event.kind_proof = "index";
    for (int index = 0; index <= 3; ++index) {
        for (const bool grows : {false, true}) {
            const auto possible = kinds_of(index, grows);
            if (std::find(possible.begin(), possible.end(), kind) == possible.end()) continue;
            event.index = index;
            event.grows = grows;
        }
    }
    return event;
}

inline Betti after(const Betti& before, Kind kind) {
    const Betti add = change(kind);
    return {before.components + add.components, before.tunnels + add.tunnels,
            before.voids + add.voids};
}

// Complete: Betti numbers follow from `start`. Frames 1 to 101; the events are by time.
inline TimelineRecord complete(Betti start, std::vector<Event> events) {
    TimelineRecord record{ten_a_second(), {}};
    Timeline& timeline = record.timeline;
    timeline.range = {0, 10};
    timeline.start = start;
    for (Event& event : events) {
        event.before = start;
        start = after(start, event.kind);
        event.after = start;
    }
    timeline.events = std::move(events);
    timeline.end = start;
    timeline.start_is_proved = timeline.end_is_proved = timeline.is_proved = true;
    return record;
}

// Three components merge to one, which gets a tunnel that closes again.
inline TimelineRecord story() {
    return complete({3, 0, 0}, {event_at(10.5, Kind::merge, {0.5, 0, 0}),
                                event_at(20.25, Kind::merge, {-0.5, 0, 0}),
                                event_at(40.2, Kind::tunnel_forms, {0, 0.5, 0}),
                                event_at(90.7, Kind::tunnel_closes, {0, 0.5, 0.1})});
}

// `count` events of kinds that its Betti numbers allow, at times at least 1e-4 s apart.
inline TimelineRecord random_complete(std::mt19937_64& random, int count) {
    std::uniform_real_distribution<double> place(-1, 1), time(0.01, 0.99);
    std::uniform_int_distribution<int> kind(int(Kind::birth), int(Kind::void_born));
    Betti now{std::uniform_int_distribution<int>(1, 9)(random), 1, 1};
    const Betti start = now;
    std::vector<Event> events;
    while (int(events.size()) < count) {
        const Kind next = Kind(kind(random));
        const Betti then = after(now, next);
        if (!then.is_possible() || then.components == 0) continue;
        now = then;
        const double seconds = 10 * (double(events.size()) + time(random)) / count;
        events.push_back(
            event_at(1 + 10 * seconds, next, {place(random), place(random), place(random)}));
    }
    return complete(start, std::move(events));
}

} // namespace isomotion::topology
