#include "topology/timeline/contradictions.h"

#include <algorithm>

#include <fmt/format.h>

#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

// What an event says of itself.
std::vector<std::string> contradictions_within(const Event& event, const Timeline& timeline,
                                               animation::FrameRate fps) {
    std::vector<std::string> found;
    const formula::Interval range = timeline.range;
    if (event.time.hi < range.lo || event.time.lo > range.hi) {
        found.push_back(fmt::format("is outside of the timeline's own frames {} to {}",
                                    frame_text(frame_at(fps, range.lo)),
                                    frame_text(frame_at(fps, range.hi))));
    }
    if (event.index > event.stratum) {
        found.push_back(fmt::format("is of index {}, where at most {} coordinates are free",
                                    event.index, event.stratum));
    }
    const std::vector<Kind> possible = kinds_of(event.index, event.grows);
    if (event.kind != Kind::none && std::ranges::find(possible, event.kind) == possible.end()) {
        found.push_back(fmt::format("what {} with index {} is no {}",
                                    event.grows ? "grows" : "shrinks", event.index,
                                    name(event.kind)));
    }
    if (event.kind_proof.empty() && event.kind != Kind::none) {
        found.emplace_back("has a kind, and an empty kind_proof says that its kind is not known");
    }
    return found;
}

} // namespace

std::vector<std::string> contradictions(const Timeline& timeline, animation::FrameRate fps) {
    std::vector<std::string> found;
    const auto &start = timeline.start, &end = timeline.end;
    if (!timeline.is_complete() || !start || !end) return found;
    Betti now = *start;
    for (const Event& event : timeline.events) {
        const std::string what =
            fmt::format("{} at frame {}", name(event.kind), frame_text(frames_at(fps, event.time)));
        for (const std::string& line : contradictions_within(event, timeline, fps)) {
            found.push_back(fmt::format("{}: {}", what, line));
        }
        if (event.before && *event.before != now) {
            found.push_back(fmt::format("{}: before it are {}; what comes before it leaves {}",
                                        what, in_words(*event.before), in_words(now)));
        }
        if (event.before) now = *event.before; // what is wrong once is told once
        now = now + change(event.kind);
        if (event.after && *event.after != now) {
            found.push_back(fmt::format("{}: after it are {}; its kind leaves {}", what,
                                        in_words(*event.after), in_words(now)));
        }
        if (event.after) now = *event.after;
    }
    if (*end != now) {
        found.push_back(fmt::format("at the end are {}; what comes before it leaves {}",
                                    in_words(*end), in_words(now)));
    }
    return found;
}

} // namespace isomotion::topology
