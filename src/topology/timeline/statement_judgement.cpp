// When a statement holds.
#include <algorithm>
#include <climits>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/searched.h"
#include "topology/timeline/statement.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// How many events there are that a statement means, as far as is proved.
struct Count {
    int certain = 0, possible = 0;
    bool is_open = false; // there may be more that nobody found
};

bool overlap(Interval a, Interval b) { return a.lo <= b.hi && b.lo <= a.hi; }

// The statement's frames and place hold some of the events that this one may have changed kinds
// with, but not all: how many of a kind are among these isn't known.
bool parts_moment(const Statement& statement, const Event& event, const Timeline& timeline,
                  animation::FrameRate fps) {
    if (event.kind_proof != "together") return false;
    bool has_inside = false, has_outside = false;
    for (const Event& other : timeline.events) {
        if (!are_interchangeable(event, other)) continue;
        const Interval frames = frames_at(fps, other.time);
        const bool is_at_place = statement.admits_place(other);
        has_inside |= is_at_place && overlap(frames, statement.frames);
        has_outside |= !is_at_place || !formula::contains(statement.frames, frames);
    }
    return has_inside && has_outside;
}

// Whether its time is certainly one that the statement speaks of. An open end is the range's: an
// event whose enclosure reaches over it may be out of it.
bool is_inside(const Statement& statement, const Event& event, Interval range,
               animation::FrameRate fps) {
    return formula::contains(statement.frames, frames_at(fps, event.time)) &&
           (std::isfinite(statement.frames.lo) || event.time.lo >= range.lo) &&
           (std::isfinite(statement.frames.hi) || event.time.hi <= range.hi);
}

bool admits_any(const Statement& statement, const std::vector<Kind>& kinds) {
    return std::ranges::any_of(kinds, [&](Kind kind) { return statement.admits(kind); });
}

bool admits_all(const Statement& statement, const std::vector<Kind>& kinds) {
    return std::ranges::all_of(kinds, [&](Kind kind) { return statement.admits(kind); });
}

Count count(const Statement& statement, const Timeline& timeline, animation::FrameRate fps) {
    Count count;
    for (const Event& event : timeline.events) {
        if (event.kind == Kind::none || !statement.admits_place(event)) continue;
        const Interval frames = frames_at(fps, event.time);
        if (!overlap(frames, statement.frames)) continue;
        bool is_meant = statement.admits(event.kind);
        bool may_be = event.kind == Kind::unknown || is_meant;
        if (parts_moment(statement, event, timeline, fps)) {
            const std::vector<Kind> kinds = kinds_of(event.index, event.grows);
            is_meant = admits_all(statement, kinds);
            may_be = admits_any(statement, kinds);
        }
        count.possible += may_be;
        count.certain +=
            event.is_proved && is_meant && is_inside(statement, event, timeline.range, fps);
    }
    count.is_open = !timeline.is_proved || !timeline.doubts.empty() ||
                    std::ranges::any_of(timeline.unresolved, [&](const Unresolved& place) {
                        return overlap(frames_at(fps, place.time), statement.frames);
                    });
    return count;
}

std::string nearest_text(const Statement& statement, const Timeline& timeline,
                         animation::FrameRate fps) {
    const Event* nearest = nullptr;
    double least = formula::infinity;
    for (const Event& event : timeline.events) {
        const bool is_meant = statement.admits(event.kind) && statement.admits_place(event);
        if (event.kind == Kind::none || !is_meant) continue;
        const Interval frames = frames_at(fps, event.time);
        const double away =
            std::max(statement.frames.lo - frames.hi, frames.lo - statement.frames.hi);
        if (away > 0 && away < least) {
            least = away;
            nearest = &event;
        }
    }
    if (!nearest) return "";
    return fmt::format("; the nearest is a {} at frame {}", name(nearest->kind),
                       frame_text(frames_at(fps, nearest->time)));
}

Judgement judge_rest(const std::vector<Statement>& all, const Timeline& timeline,
                     animation::FrameRate fps) {
    Judgement judgement{Truth::holds, ""};
    const auto meant = [&](const Event& event, Kind kind) {
        return std::ranges::any_of(all, [&](const Statement& other) {
            return !other.is_nothing_else && other.most > 0 && other.admits(kind) &&
                   other.admits_place(event) &&
                   formula::contains(other.frames, frames_at(fps, event.time));
        });
    };
    const auto may_be_meant = [&](const Event& event, Kind kind) {
        return std::ranges::any_of(all, [&](const Statement& other) {
            return !other.is_nothing_else && other.most > 0 && other.admits(kind) &&
                   other.admits_place(event) && overlap(frames_at(fps, event.time), other.frames);
        });
    };
    for (const Event& event : timeline.events) {
        if (event.kind == Kind::none) continue;
        const bool is_parted = std::ranges::any_of(all, [&](const Statement& other) {
            return !other.is_nothing_else && parts_moment(other, event, timeline, fps);
        });
        const std::vector<Kind> kinds =
            is_parted ? kinds_of(event.index, event.grows) : std::vector{event.kind};
        if (std::ranges::all_of(kinds, [&](Kind kind) { return meant(event, kind); })) continue;
        const bool certain =
            event.is_proved && event.kind != Kind::unknown &&
            formula::contains(timeline.range, event.time) &&
            std::ranges::none_of(kinds, [&](Kind kind) { return may_be_meant(event, kind); });
        judgement.why += fmt::format("{}{} at frame {}{}", judgement.why.empty() ? "" : ", ",
                                     name(event.kind), frame_text(frames_at(fps, event.time)),
                                     certain ? "" : " (not proved to be another)");
        if (certain) {
            judgement.truth = Truth::fails;
        } else if (judgement.truth == Truth::holds) {
            judgement.truth = Truth::open;
        }
    }
    if (!judgement.why.empty()) judgement.why = "there is " + judgement.why;
    if (judgement.truth == Truth::holds &&
        (!timeline.is_proved || !timeline.doubts.empty() || !timeline.unresolved.empty())) {
        return {Truth::open, "nothing else was found, but it is not proved"};
    }
    return judgement;
}

} // namespace

Judgement judge(const Statement& statement, const std::vector<Statement>& all,
                const Timeline& timeline, animation::FrameRate fps) {
    if (statement.is_nothing_else) return judge_rest(all, timeline, fps);
    const Count n = count(statement, timeline, fps);
    const std::string found = n.certain == n.possible
                                  ? fmt::format("found {}", n.certain)
                                  : fmt::format("found {} to {}", n.certain, n.possible);
    if (n.certain > statement.most) return {Truth::fails, found};
    if (const std::string missing = unsearched(statement.asked, timeline.range, fps);
        !missing.empty()) {
        return {Truth::open, fmt::format("{}, but {}", found, missing)};
    }
    if (!n.is_open && n.possible < statement.least) {
        return {Truth::fails, found + nearest_text(statement, timeline, fps)};
    }
    if (n.certain >= statement.least && !n.is_open && n.possible <= statement.most) {
        return {Truth::holds, ""};
    }
    // More events do no harm to "at least".
    if (n.certain >= statement.least && statement.most == INT_MAX && timeline.doubts.empty()) {
        return {Truth::holds, ""};
    }
    return {Truth::open, found + (n.is_open ? ", and it is not proved that there are no more"
                                            : ", not all of them told apart")};
}

} // namespace isomotion::topology
