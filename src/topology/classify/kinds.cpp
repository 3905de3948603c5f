#include "topology/classify/kinds.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace isomotion::topology {
namespace {

using formula::Interval;

// The one of an event's two kinds that changes b1.
Kind by_path(const Event& event) {
    if (event.index == 1) return event.grows ? Kind::tunnel_forms : Kind::tunnel_breaks;
    return event.grows ? Kind::tunnel_closes : Kind::tunnel_opens;
}

// ... and the other one: it changes b0 (index 1) or b2 (index 2).
Kind by_parts(const Event& event) {
    if (event.index == 1) return event.grows ? Kind::merge : Kind::split;
    return event.grows ? Kind::void_forms : Kind::void_opens;
}

bool is_open(const Event& event) {
    return event.kind == Kind::unknown && (event.index == 1 || event.index == 2);
}

void settle(Event& event, Kind kind, const char* proof) {
    event.kind = kind;
    event.kind_proof = proof;
}

// Whether some time is in the enclosures of all of them, so that none is known to come before
// another.
bool is_one_moment(std::span<const Interval> times) {
    double last_begin = -formula::infinity, first_end = formula::infinity;
    for (const Interval& time : times) {
        last_begin = std::max(last_begin, time.lo);
        first_end = std::min(first_end, time.hi);
    }
    return last_begin <= first_end;
}

// `change` is what these events of one index add to b0 (1) or b2 (2): each of them adds `parts` or
// nothing.
bool force(std::vector<Event*> events, int change, int Betti::*number, const char* proof) {
    int least = 0, most = 0;
    for (const Event* event : events) {
        const int parts = topology::change(by_parts(*event)).*number;
        (parts < 0 ? least : most) += parts;
    }
    if (change < least || change > most) return false;
    if (change != least && change != most) {
        // At one moment there is no order: as many as there are, the first ones by convention.
        std::vector<Interval> times;
        times.reserve(events.size());
        for (const Event* event : events) times.push_back(event->time);
        if (!is_one_moment(times) || (least != 0 && most != 0)) return true;
        int parts = std::abs(change);
        for (Event* event : events)
            settle(*event, parts-- > 0 ? by_parts(*event) : by_path(*event), "together");
        return true;
    }
    for (Event* event : events) {
        const int parts = topology::change(by_parts(*event)).*number;
        const bool changes_parts = (parts < 0) == (change == least) && least != most;
        settle(*event, changes_parts ? by_parts(*event) : by_path(*event), proof);
    }
    return true;
}

// How many open events there are, and at how many moments: groups of events whose times overlap.
struct Crowd {
    std::ptrdiff_t open = 0, moments = 0;
};

Crowd crowd_of(const Timeline& timeline) {
    std::vector<Interval> times;
    for (const Event& event : timeline.events) {
        if (is_open(event)) times.push_back(event.time);
    }
    std::ranges::sort(times, {}, &Interval::lo);
    Crowd crowd{std::ssize(times), 0};
    double end = -formula::infinity;
    for (const Interval& time : times) {
        crowd.moments += time.lo > end;
        end = std::max(end, time.hi);
    }
    return crowd;
}

void settle_by_index(Timeline& timeline) {
    for (Event& event : timeline.events) {
        if (event.kind != Kind::unknown) {
            if (event.kind_proof.empty() && event.kind != Kind::none) event.kind_proof = "index";
            continue;
        }
        const std::vector<Kind> kinds = kinds_of(event.index, event.grows);
        if (kinds.size() == 1) settle(event, kinds.front(), "index");
    }
}

void settle_by_path(Timeline& timeline, const KindProofs& proofs, int effort) {
    if (!proofs.paths || (proofs.stopped && proofs.stopped())) return;
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < timeline.events.size(); ++k) {
        if (is_open(timeline.events[k]) && timeline.events[k].is_proved) open.push_back(k);
    }
    const std::vector<Sides> sides = proofs.paths(open, effort);
    for (std::size_t k = 0; k < open.size(); ++k) {
        Event& event = timeline.events[open[k]];
        if (sides[k] == Sides::joined) settle(event, by_path(event), "path");
        if (sides[k] == Sides::apart) settle(event, by_parts(event), "apart");
    }
}

// Between these events, counted from 0 to all, no time of two events overlaps: a frame may be had.
struct Gap {
    std::size_t at; // before this event
    double time;
    double width;
};

bool is_degenerate_between(const Timeline& timeline, double from, double to) {
    return std::ranges::any_of(timeline.unresolved, [&](const Unresolved& place) {
        return place.time.hi >= from && place.time.lo <= to;
    });
}

// A search that is complete but for its degenerate places proves nothing whole, but has no doubts.
bool is_whole_elsewhere(const Timeline& timeline) {
    return timeline.is_proved || (!timeline.unresolved.empty() && timeline.doubts.empty());
}

// Counts between frames, and asks for more of these where that doesn't do.
class Counting {
public:
    // Asks for `most_frames`, where one that has no proof counts as `failure`. It adds the times of
    // those to `failed` and doesn't ask for them again.
    Counting(Timeline& timeline, const KindProofs& proofs, int most_frames, int failure,
             std::vector<double>& failed)
        : timeline_(timeline)
        , proofs_(proofs)
        , nothing_missing_(is_whole_elsewhere(timeline))
        , frames_left_(proofs.frame ? most_frames : 0)
        , failure_(failure)
        , failed_(failed) {}

    struct Checkpoint {
        std::size_t at; // before this event
        double time;
        Betti betti;
    };

    void between(const Checkpoint& from, const Checkpoint& to) {
        const auto events = std::span(timeline_.events).subspan(from.at, to.at - from.at);
        const bool is_whole = nothing_missing_ && std::ranges::all_of(events, &Event::is_proved) &&
                              !is_degenerate_between(timeline_, from.time, to.time);
        if (is_whole && !count_kinds(events, from.betti, to.betti)) {
            std::string doubt =
                fmt::format("no kinds of the events from {} s to {} s agree with the frames",
                            from.time, to.time);
            if (std::ranges::find(timeline_.doubts, doubt) == timeline_.doubts.end())
                timeline_.doubts.push_back(std::move(doubt));
            return;
        }
        if (std::ranges::none_of(events, is_open) && is_whole) return;
        for (const Gap& gap : gaps(from, to)) {
            if (frames_left_ <= 0 || (proofs_.stopped && proofs_.stopped())) return;
            if (std::ranges::find(failed_, gap.time) != failed_.end()) continue;
            const auto betti = proofs_.frame(gap.time);
            frames_left_ -= betti ? 1 : failure_;
            if (!betti) {
                failed_.push_back(gap.time);
                continue;
            }
            const Checkpoint middle{gap.at, gap.time, *betti};
            checkpoints_.push_back(middle);
            between(from, middle);
            between(middle, to);
            return;
        }
    }

    std::vector<Checkpoint> frames() && {
        return std::move(checkpoints_);
    } // those that were proved
    int frames_left() const { return std::max(frames_left_, 0); }

private:
    // The gaps where a frame would part the open events: the widest first, if they leave events of
    // both directions apart.
    std::vector<Gap> gaps(const Checkpoint& from, const Checkpoint& to) const {
        std::vector<Gap> found;
        double end = from.time; // of all events so far
        // The least time of all events from each on: the order is that of the middles of their
        // times.
        std::vector<double> begins(to.at - from.at + 1, to.time);
        for (std::size_t k = to.at; k-- > from.at;) {
            begins[k - from.at] = std::min(begins[k - from.at + 1], timeline_.events[k].time.lo);
        }
        std::size_t open_before = 0, open = 0;
        for (std::size_t k = from.at; k < to.at; ++k) open += is_open(timeline_.events[k]);
        for (std::size_t k = from.at; k < to.at; ++k) {
            const Event& event = timeline_.events[k];
            const bool is_between = open_before > 0 && open_before < open;
            const double begin = begins[k - from.at];
            if (is_between && begin > end && !is_degenerate_between(timeline_, end, begin)) {
                found.push_back({k, end / 2 + begin / 2, begin - end});
            }
            end = std::max(end, event.time.hi);
            open_before += is_open(event);
        }
        std::ranges::sort(found, std::greater{}, &Gap::width);
        constexpr std::size_t most_tries = 4;
        if (found.size() > most_tries) found.resize(most_tries);
        return found;
    }

    Timeline& timeline_;
    const KindProofs& proofs_;
    const bool nothing_missing_; // but in degenerate places
    int frames_left_, failure_;
    std::vector<double>& failed_;
    std::vector<Checkpoint> checkpoints_;
};

// Where an end's own frame has no proof, one before the first event, or after the last, says the
// same: nothing happens in between.
void prove_ends(Timeline& timeline, const KindProofs& proofs) {
    if (!proofs.frame || !is_whole_elsewhere(timeline)) return;
    double first = timeline.range.hi, last = timeline.range.lo;
    const auto add = [&](const Interval& time) {
        first = std::min(first, time.lo);
        last = std::max(last, time.hi);
    };
    for (const Event& event : timeline.events) add(event.time);
    for (const Unresolved& place : timeline.unresolved) add(place.time);
    // Enclosures of what happens at an end reach beyond it, where no rule of the motion holds.
    const auto prove = [&](double end, double beside, std::optional<Betti>& betti,
                           bool& is_proved) {
        const double quiet = std::clamp(beside, timeline.range.lo, timeline.range.hi);
        for (const double part : {0.5, 0.2, 0.8}) {
            if (is_proved || end == quiet || (proofs.stopped && proofs.stopped())) return;
            const auto found = proofs.frame(end + part * (quiet - end));
            if (!found) continue;
            betti = found;
            is_proved = true;
        }
    };
    prove(timeline.range.lo, first, timeline.start, timeline.start_is_proved);
    prove(timeline.range.hi, last, timeline.end, timeline.end_is_proved);
}

// Adds frames near ends that have no proof, in the widest of the gaps between the events next to
// them: a frame close to an event is hard to prove.
void add_frames_near_ends(const Timeline& timeline, const KindProofs& proofs,
                          std::vector<Counting::Checkpoint>& known) {
    constexpr std::size_t nearest = 12, most_tries = 3;
    if (!proofs.frame || timeline.events.empty() || !is_whole_elsewhere(timeline)) return;
    // The least time of all events from each on.
    std::vector<double> begins(timeline.events.size() + 1, timeline.range.hi);
    for (std::size_t k = timeline.events.size(); k-- > 0;)
        begins[k] = std::min(begins[k + 1], timeline.events[k].time.lo);
    std::vector<Gap> gaps;
    double end = timeline.events.front().time.hi; // of all events so far
    for (std::size_t k = 1; k < timeline.events.size(); ++k) {
        const double begin = begins[k];
        if (begin > end && !is_degenerate_between(timeline, end, begin))
            gaps.push_back({k, end / 2 + begin / 2, begin - end});
        end = std::max(end, timeline.events[k].time.hi);
    }
    const auto add = [&](std::span<Gap> some) {
        std::ranges::sort(some, std::greater{}, &Gap::width);
        for (const Gap& gap : some.first(std::min(most_tries, some.size()))) {
            if (proofs.stopped && proofs.stopped()) return;
            const auto is_same = [&](const Counting::Checkpoint& k) { return k.time == gap.time; };
            if (std::ranges::any_of(known, is_same)) return;
            if (const auto betti = proofs.frame(gap.time)) {
                known.push_back({gap.at, gap.time, *betti});
                return;
            }
        }
    };
    const std::size_t count = std::min(nearest, gaps.size());
    std::vector<Gap> first(gaps.begin(), gaps.begin() + std::ptrdiff_t(count));
    std::vector<Gap> last(gaps.end() - std::ptrdiff_t(count), gaps.end());
    if (!timeline.start_is_proved) add(first);
    if (!timeline.end_is_proved) add(last);
    std::ranges::sort(known, {}, &Counting::Checkpoint::time);
}

// Times at which something happens, joined where they overlap; whether it is degenerate.
std::vector<std::pair<Interval, bool>> moments_of(const Timeline& timeline) {
    std::vector<std::pair<Interval, bool>> moments;
    for (const Event& event : timeline.events) moments.emplace_back(event.time, false);
    for (const Unresolved& place : timeline.unresolved) moments.emplace_back(place.time, true);
    std::ranges::sort(moments, {}, [](const auto& snapshot) { return snapshot.first.lo; });
    std::vector<std::pair<Interval, bool>> joined;
    for (const auto& [time, is_degenerate] : moments) {
        if (!joined.empty() && time.lo <= joined.back().first.hi) {
            joined.back().first = hull(joined.back().first, time);
            joined.back().second |= is_degenerate;
        } else {
            joined.emplace_back(time, is_degenerate);
        }
    }
    return joined;
}

// The ends, and frames close about degenerate places.
std::vector<Counting::Checkpoint> known_frames(const Timeline& timeline, const KindProofs& proofs) {
    std::vector<Counting::Checkpoint> known;
    if (timeline.start && timeline.start_is_proved)
        known.push_back({0, timeline.range.lo, *timeline.start});
    if (proofs.frame) {
        // Frames are sought between these.
        const std::vector<std::pair<Interval, bool>> joined = moments_of(timeline);
        for (std::size_t k = 0; k <= joined.size(); ++k) {
            const bool beside_degenerate =
                (k > 0 && joined[k - 1].second) || (k < joined.size() && joined[k].second);
            if (!beside_degenerate) continue;
            const double from = k > 0 ? joined[k - 1].first.hi : timeline.range.lo;
            const double to = k < joined.size() ? joined[k].first.lo : timeline.range.hi;
            const double time = from / 2 + to / 2;
            if (!(from < time && time < to)) continue;
            const auto before = std::ranges::count_if(
                timeline.events, [&](const Event& event) { return event.time.hi < time; });
            if (const auto betti = proofs.frame(time))
                known.push_back({std::size_t(before), time, *betti});
        }
    }
    if (timeline.end && timeline.end_is_proved)
        known.push_back({timeline.events.size(), timeline.range.hi, *timeline.end});
    return known;
}

// Sets Betti numbers beside degenerate places, where no event lies between these and the frame.
void describe_unresolved(Timeline& timeline, std::span<const Counting::Checkpoint> frames) {
    for (Unresolved& place : timeline.unresolved) {
        const auto is_quiet = [&](double from, double to) {
            const auto is_between = [&](const Interval& time) {
                return time.hi >= from && time.lo <= to;
            };
            const auto is_another = [&](const Unresolved& other) {
                return other.time.hi < place.time.lo || other.time.lo > place.time.hi;
            };
            return std::ranges::none_of(timeline.events, is_between, &Event::time) &&
                   std::ranges::none_of(timeline.unresolved, [&](const Unresolved& other) {
                       return is_another(other) && is_between(other.time);
                   });
        };
        for (const auto& frame : frames) {
            if (frame.time < place.time.lo && is_quiet(frame.time, place.time.lo))
                place.before = frame.betti;
            if (frame.time > place.time.hi && !place.after && is_quiet(place.time.hi, frame.time))
                place.after = frame.betti;
        }
    }
}

// Sets Betti numbers from a known frame on, as far as kinds are known.
void read_off(Timeline& timeline, const Counting::Checkpoint& frame) {
    const auto ok = [&](const Event& event) { return event.kind != Kind::unknown; };
    const auto add = [](Betti a, const Betti& b, int sign) {
        a.components += sign * b.components;
        a.tunnels += sign * b.tunnels;
        a.voids += sign * b.voids;
        return a;
    };
    Betti now = frame.betti;
    double time = frame.time;
    for (std::size_t k = frame.at; k < timeline.events.size(); ++k) {
        Event& event = timeline.events[k];
        if (event.before || is_degenerate_between(timeline, time, event.time.hi)) break;
        event.before = now;
        if (!ok(event)) break;
        now = add(now, change(event.kind), 1);
        event.after = now;
        time = event.time.hi;
    }
    now = frame.betti;
    time = frame.time;
    for (std::size_t k = frame.at; k-- > 0;) {
        Event& event = timeline.events[k];
        if (event.after || is_degenerate_between(timeline, event.time.lo, time)) break;
        event.after = now;
        if (!ok(event)) break;
        now = add(now, change(event.kind), -1);
        event.before = now;
        time = event.time.lo;
    }
}

// What proved events lead to from a proved frame is as good as a frame of the end itself.
void read_off_ends(Timeline& timeline) {
    if (!is_whole_elsewhere(timeline) || timeline.events.empty()) return;
    if (!std::ranges::all_of(timeline.events, &Event::is_proved)) return;
    double first = timeline.range.hi, last = timeline.range.lo;
    for (const Event& event : timeline.events) {
        first = std::min(first, event.time.lo);
        last = std::max(last, event.time.hi);
    }
    const auto read = [&](const std::optional<Betti>& from, double low, double high,
                          std::optional<Betti>& betti, bool& is_proved) {
        if (is_proved || !from || is_degenerate_between(timeline, low, high)) return;
        betti = from;
        is_proved = true;
    };
    read(timeline.events.front().before, timeline.range.lo, first, timeline.start,
         timeline.start_is_proved);
    read(timeline.events.back().after, last, timeline.range.hi, timeline.end,
         timeline.end_is_proved);
}

std::string text(const Betti& b) {
    return fmt::format("({}, {}, {})", b.components, b.tunnels, b.voids);
}

// Checks every count that must come out.
void check(Timeline& timeline) {
    const auto doubt = [&](std::string words) { timeline.doubts.push_back(std::move(words)); };
    int euler = 0;
    Betti sum{};
    bool all_known = true;
    for (Event& event : timeline.events) {
        const std::vector<Kind> kinds = kinds_of(event.index, event.grows);
        if (event.kind == Kind::none || kinds.empty()) continue;
        euler += euler_change(event);
        all_known &= event.kind != Kind::unknown;
        sum.components += change(event.kind).components;
        sum.tunnels += change(event.kind).tunnels;
        sum.voids += change(event.kind).voids;
        if (event.kind != Kind::unknown && std::ranges::find(kinds, event.kind) == kinds.end()) {
            doubt(fmt::format("the event at {} s is no {}: index {}", mid(event.time),
                              name(event.kind), event.index));
        }
        for (std::optional<Betti>* betti : {&event.before, &event.after}) {
            if (!*betti || (*betti)->is_possible()) continue;
            doubt(fmt::format("Betti numbers {} at {} s", text(**betti), mid(event.time)));
            betti->reset();
        }
    }
    for (std::size_t k = 1; k < timeline.events.size(); ++k) {
        const auto &a = timeline.events[k - 1].after, &b = timeline.events[k].before;
        if (a && b && *a != *b && timeline.unresolved.empty()) {
            doubt(fmt::format("Betti numbers {} and {} between {} s and {} s", text(*a), text(*b),
                              mid(timeline.events[k - 1].time), mid(timeline.events[k].time)));
        }
    }
    if (!timeline.start || !timeline.end || !timeline.unresolved.empty()) return;
    const int expected = timeline.end->euler() - timeline.start->euler();
    if (euler != expected) {
        doubt(fmt::format("the events change the Euler number by {}, from start to end it changes "
                          "by {}",
                          euler, expected));
    }
    const Betti end{timeline.start->components + sum.components,
                    timeline.start->tunnels + sum.tunnels, timeline.start->voids + sum.voids};
    if (all_known && end != *timeline.end) {
        doubt(fmt::format("the events lead from {} to {}, the end is {}", text(*timeline.start),
                          text(end), text(*timeline.end)));
    }
}

} // namespace

bool count_kinds(std::span<Event> events, const Betti& before, const Betti& after) {
    int of_components = after.components - before.components, of_voids = after.voids - before.voids;
    std::vector<Event*> first, second;
    for (Event& event : events) {
        if (is_open(event)) {
            (event.index == 1 ? first : second).push_back(&event);
            continue;
        }
        of_components -= change(event.kind).components;
        of_voids -= change(event.kind).voids;
    }
    // Two frames about one moment are a closer look than counting.
    std::vector<Interval> times;
    for (const Event& event : events) times.push_back(event.time);
    const char* proof = is_one_moment(times) ? "frames" : "counting";
    const bool agree = force(first, of_components, &Betti::components, proof) &&
                       force(second, of_voids, &Betti::voids, proof);
    if (!agree) {
        for (Event* event : first) settle(*event, Kind::unknown, "");
    }
    return agree;
}

void find_kinds(Timeline& timeline, const KindProofs& proofs) {
    settle_by_index(timeline);
    prove_ends(timeline, proofs);
    std::vector<Counting::Checkpoint> known = known_frames(timeline, proofs);
    add_frames_near_ends(timeline, proofs, known);
    std::vector<Counting::Checkpoint> frames = known;
    int frames_left = proofs.most_frames;
    std::vector<double> failed;
    const auto count = [&](int most_frames, int failure = 1) {
        const int allowed = std::min(most_frames, frames_left);
        Counting counting(timeline, proofs, allowed, failure, failed);
        const std::vector<Counting::Checkpoint> between = frames;
        for (std::size_t k = 1; k < between.size(); ++k)
            counting.between(between[k - 1], between[k]);
        frames_left -= allowed - counting.frames_left();
        for (const auto& frame : std::move(counting).frames()) frames.push_back(frame);
        std::ranges::sort(frames, {}, &Counting::Checkpoint::time);
    };
    // What is cheap first: paths leave little to count. Boxes part the sides of some events in the
    // time that a frame takes, which may tell of hundreds.
    // One without a proof takes about as long as eight with one.
    const std::ptrdiff_t events_a_frame = proofs.events_a_frame;
    constexpr int failure = 8;
    count(0);
    // A frame between two moments at which many events come tells of all of these, and paths of
    // few: they may not lead over one another.
    if (const Crowd crowd = crowd_of(timeline); crowd.open >= events_a_frame * crowd.moments)
        count(int(crowd.moments));
    for (const int effort : {0, 1, 2}) {
        if (std::ranges::none_of(timeline.events, is_open)) break;
        settle_by_path(timeline, proofs, effort);
        const auto left = std::ranges::count_if(timeline.events, is_open);
        count(effort == 0   ? 0
              : effort == 1 ? int(left / events_a_frame)
                            : frames_left,
              effort == 1 ? failure : 1);
    }
    for (const auto& frame : frames) read_off(timeline, frame);
    read_off_ends(timeline);
    describe_unresolved(timeline, known);
    check(timeline);
}

} // namespace isomotion::topology
