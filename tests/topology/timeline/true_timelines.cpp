#include "topology/timeline/true_timelines.h"

#include <algorithm>

#include "topology/golden.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

// One of each kind, at other times and places, in an order that the numbers allow.
TimelineRecord every_kind() {
    std::vector<Event> events;
    for (const Kind kind :
         {Kind::birth, Kind::merge, Kind::split, Kind::death, Kind::tunnel_forms,
          Kind::tunnel_closes, Kind::tunnel_opens, Kind::tunnel_breaks, Kind::void_forms,
          Kind::void_fills, Kind::void_born, Kind::void_opens, Kind::none}) {
        const double k = double(events.size());
        events.push_back(event_at(5.5 + 7 * k, kind, {0.1 * k - 0.6, 0.05 * k, -0.3}));
    }
    return complete({2, 1, 1}, std::move(events));
}

// Events on faces, edges and at corners; each has as high an index as there is room for.
TimelineRecord every_stratum() {
    std::vector<Event> events;
    for (int stratum = 0; stratum <= 3; ++stratum) {
        for (int index = 0; index <= stratum; ++index) {
            for (const bool grows : {true, false}) {
                const double k = double(events.size());
                Event event =
                    event_at(3.25 + 2 * k, kinds_of(index, grows).front(), {0.02 * k, 0.5, -1});
                event.stratum = stratum;
                events.push_back(event);
                event.where[0] = near(-0.02 * k - 0.01);
                event.time = near(0.325 + 0.2 * k);
                event.kind = Kind::none;
                events.push_back(event);
            }
        }
    }
    return complete({9, 9, 9}, std::move(events));
}

TimelineRecord all_at_once() {
    std::vector<Event> events;
    for (const Kind kind : {Kind::merge, Kind::birth, Kind::none, Kind::tunnel_forms}) {
        for (const double x : {-0.5, 0.5}) {
            const double y = 0.2 * double(events.size());
            events.push_back(event_at(30, kind, {x, y, 0.25}));
        }
    }
    return complete({4, 0, 0}, std::move(events));
}

TimelineRecord known_together() {
    TimelineRecord record = complete({4, 0, 0}, {event_at(12, Kind::merge, {-0.5, 0, 0}),
                                                 event_at(12, Kind::merge, {0, 0, 0}),
                                                 event_at(12, Kind::tunnel_forms, {0.5, 0, 0})});
    for (Event& event : record.timeline.events) event.kind_proof = "together";
    return record;
}

// Enclosures that reach over the ends of frames 1 to 101.
TimelineRecord at_the_ends(bool has_first, bool has_last) {
    std::vector<Event> events;
    if (has_first) events.push_back(event_at(1, Kind::merge, {0.5, 0, 0}));
    events.push_back(event_at(50, Kind::tunnel_forms, {0, 0.5, 0}));
    if (has_last) events.push_back(event_at(101, Kind::split, {-0.5, 0, 0}));
    return complete({3, 0, 0}, std::move(events));
}

} // namespace

std::vector<NamedTimeline> complete_timelines() {
    std::mt19937_64 random(5);
    std::vector<NamedTimeline> all = {
        {"nothing_happens", complete({1, 0, 0}, {})},
        {"story", story()},
        {"every_kind", every_kind()},
        {"every_stratum", every_stratum()},
        {"all_at_once", all_at_once()},
        {"known_together", known_together()},
        {"at_the_first_frame", at_the_ends(true, false)},
        {"at_the_last_frame", at_the_ends(false, true)},
        {"at_both_ends", at_the_ends(true, true)},
        {"random", random_complete(random, 15)},
    };
    for (const std::string& name : golden_names()) {
        all.push_back({name, read_timeline(golden_file(name)), name == "tangle" ? 4u : 1u});
    }
    all.push_back({"blobby75", read_timeline(golden_file("spheres/blobby75")), 140});
    std::erase_if(all,
                  [](const NamedTimeline& each) { return !each.record.timeline.is_complete(); });
    return all;
}

std::vector<NamedTimeline> incomplete_timelines() {
    std::vector<NamedTimeline> all(5, {"", story()});
    std::size_t k = 0;
    const auto edit = [&](const char* name) -> Timeline& {
        all[k].name = name;
        return all[k++].record.timeline;
    };
    edit("unresolved").unresolved.push_back({{3, 3.5}, {}, "flat", Betti{1, 0, 0}, Betti{1, 0, 0}});
    edit("unproved_event").events[1].is_proved = false;
    edit("unknown_kind").events[2].kind = Kind::unknown;
    edit("unproved_end").end_is_proved = false;
    edit("doubtful").doubts.emplace_back("interrupted");
    for (const std::string& name : golden_names()) {
        TimelineRecord record = read_timeline(golden_file(name));
        if (!record.timeline.is_complete()) all.push_back({name, std::move(record)});
    }
    return all;
}

void follow_from_start(Timeline& timeline) {
    Betti now = timeline.start.value_or(Betti{});
    for (Event& event : timeline.events) {
        event.before = now;
        now = after(now, event.kind);
        for (const auto number : {&Betti::components, &Betti::tunnels, &Betti::voids}) {
            now.*number = std::max(now.*number, 0);
        }
        event.after = now;
    }
    timeline.end = now;
}

} // namespace isomotion::topology
