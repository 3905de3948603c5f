#include "topology/timeline/compare.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/matching.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// Between the nearest members of two intervals, and between the farthest.
double least_distance(Interval a, Interval b) { return std::max({0.0, a.lo - b.hi, b.lo - a.hi}); }
double most_distance(Interval a, Interval b) { return std::max(a.hi - b.lo, b.hi - a.lo); }

double place_distance(const Event& a, const Event& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        sum += std::pow(least_distance(a.where[k], b.where[k]), 2);
    }
    return std::sqrt(sum);
}

double diagonal(const TimelineHeader& header) {
    double sum = 0;
    for (const Interval side : header.start_bounds) sum += std::pow(side.hi - side.lo, 2);
    return std::isfinite(sum) && sum > 0 ? std::sqrt(sum) : 1;
}

// What is said of each event of a moment is that it has one of the two kinds that its index leaves.
bool may_change_kinds(const Event& a, const Event& b) {
    return a.kind_proof == "together" && b.kind_proof == "together" && a.index == b.index &&
           a.grows == b.grows;
}

class Comparison {
public:
    Comparison(const TimelineRecord& expected, const TimelineRecord& found, double dt)
        : expected_(expected.timeline)
        , found_(found.timeline)
        , fps_(found.header.fps)
        , dt_(dt)
        , span_(std::max(expected_.range.hi - expected_.range.lo, dt))
        , diagonal_(diagonal(expected.header)) {
        same_place_ = diagonal_ * std::max(1e-6, dt / span_);
        if (expected.header.fingerprint != found.header.fingerprint) {
            check_.notes.emplace_back("the scene is not the one that the expectation was made of");
        }
    }

    Check run() {
        check_range();
        tell_gaps();
        for (std::size_t k = 0; k < expected_.events.size(); ++k) wanted_.push_back(k);
        for (std::size_t k = 0; k < found_.events.size(); ++k) {
            // What is certainly at other times than the expectation spans is none of its business.
            if (most_inside(found_.events[k].time)) there_.push_back(k);
        }
        pair_equals();
        pair_rest();
        for (const std::size_t k : wanted_) missing(expected_.events[k]);
        for (const std::size_t k : there_) extra(found_.events[k]);
        compare_moments();
        compare_ends();
        return std::move(check_);
    }

private:
    void differ(std::string line) { check_.differences.push_back(std::move(line)); }
    void doubt(std::string line) { check_.undecided.push_back(std::move(line)); }

    std::string frame_of(Interval time) const { return frame_text(frames_at(fps_, time)); }
    std::string place(const Event& event) const {
        return fmt::format("at frame {} ({:.9g} s), near ({:.4g}, {:.4g}, {:.4g})",
                           frame_of(event.time), mid(event.time), mid(event.where[0]),
                           mid(event.where[1]), mid(event.where[2]));
    }
    bool most_inside(Interval time) const {
        return time.hi >= expected_.range.lo - dt_ && time.lo <= expected_.range.hi + dt_;
    }

    void check_range() {
        const Interval wanted = expected_.range, had = found_.range;
        if (had.lo <= wanted.lo + dt_ && had.hi >= wanted.hi - dt_) return;
        doubt(fmt::format("searched were frames {} to {}, expected are events of {} to {}",
                          frame_text(frame_at(fps_, had.lo)), frame_text(frame_at(fps_, had.hi)),
                          frame_text(frame_at(fps_, wanted.lo)),
                          frame_text(frame_at(fps_, wanted.hi))));
    }
    void tell_gaps() {
        for (const std::string& reason : gaps(found_, fps_)) doubt("found: " + reason);
        for (const std::string& reason : gaps(expected_, fps_)) {
            doubt("the expectation itself is incomplete: " + reason);
        }
    }

    bool is_same(const Event& a, const Event& b) const {
        return (a.kind == b.kind || may_change_kinds(a, b)) &&
               least_distance(a.time, b.time) <= dt_ && place_distance(a, b) <= same_place_;
    }

    // Most events of most checks; what is left is matched in more than linear time.
    void pair_equals() {
        std::vector<std::size_t> alone;
        std::vector<char> taken(found_.events.size(), 0);
        double width = 0; // of the widest enclosure: how far apart overlapping events may begin
        for (const std::size_t f : there_) {
            width = std::max(width, formula::width(found_.events[f].time));
        }
        // Lists are by time but for enclosures that overlap.
        std::ranges::stable_sort(there_, {},
                                 [&](std::size_t f) { return found_.events[f].time.lo; });
        for (const std::size_t e : wanted_) {
            const Event& event = expected_.events[e];
            const auto begin =
                std::ranges::lower_bound(there_, event.time.lo - dt_ - width, {},
                                         [&](std::size_t f) { return found_.events[f].time.lo; });
            std::optional<std::size_t> best;
            for (auto it = begin; it != there_.end(); ++it) {
                const Event& other = found_.events[*it];
                if (other.time.lo > event.time.hi + dt_) break;
                if (taken[*it] || !is_same(event, other)) continue;
                if (!best ||
                    place_distance(event, other) < place_distance(event, found_.events[*best])) {
                    best = *it;
                }
            }
            if (!best) {
                alone.push_back(e);
                continue;
            }
            taken[*best] = 1;
            paired(event, found_.events[*best]);
        }
        wanted_ = std::move(alone);
        std::erase_if(there_, [&](std::size_t f) { return taken[f] != 0; });
    }

    // An item alone costs 1 and says one line. Half of the time and the bounds together is too far
    // for one event; another kind is as bad as an eighth.
    void pair_rest() {
        const auto cost = [&](std::size_t e, std::size_t f) {
            const Event& a = expected_.events[wanted_[e]];
            const Event& b = found_.events[there_[f]];
            const double apart = least_distance(a.time, b.time) / span_;
            const double kind = a.kind == b.kind ? 0 : 0.5;
            return kind + 4 * (apart + place_distance(a, b) / diagonal_);
        };
        const auto pairs = match(wanted_.size(), there_.size(), cost, 1);
        std::vector<std::size_t> alone;
        std::vector<char> taken(there_.size(), 0);
        for (std::size_t e = 0; e < pairs.size(); ++e) {
            if (!pairs[e]) {
                alone.push_back(wanted_[e]);
                continue;
            }
            taken[*pairs[e]] = 1;
            paired(expected_.events[wanted_[e]], found_.events[there_[*pairs[e]]]);
        }
        std::vector<std::size_t> others;
        for (std::size_t f = 0; f < there_.size(); ++f) {
            if (!taken[f]) others.push_back(there_[f]);
        }
        wanted_ = std::move(alone);
        there_ = std::move(others);
    }

    void paired(const Event& wanted, const Event& event) {
        const bool certain = wanted.is_proved && event.is_proved;
        const auto tell = [&](std::string line) {
            certain ? differ(std::move(line)) : doubt("not proved: " + std::move(line));
        };
        const bool same_kind = same_kind_or_told(wanted, event, tell);
        const bool same_time = same_time_or_told(wanted, event, tell);
        const double apart = place_distance(wanted, event);
        const bool same_place = apart <= same_place_;
        if (!same_place && same_time) {
            tell(fmt::format("elsewhere: {} {}, {:.3g} from where it was expected",
                             name(event.kind), place(event), apart));
        }
        if (same_kind && same_time && same_place) ++check_.agreed;
    }

    template<class Tell>
    bool same_kind_or_told(const Event& wanted, const Event& event, Tell&& tell) {
        if (may_change_kinds(wanted, event)) {
            together_.emplace_back(&wanted, &event);
            return true;
        }
        if (wanted.kind == event.kind) return same_change(wanted, event, tell);
        const std::string line = fmt::format("kind: {} {}, expected {}", name(event.kind),
                                             place(event), name(wanted.kind));
        if (wanted.kind == Kind::unknown || event.kind == Kind::unknown) {
            doubt(line);
        } else {
            tell(line);
        }
        return false;
    }

    // What events of unknown kind add is known where frames about them are.
    template<class Tell>
    bool same_change(const Event& wanted, const Event& event, Tell&& tell) const {
        if (!wanted.before || !wanted.after || !event.before || !event.after) return true;
        const auto added = [](const Event& e) {
            return Betti{e.after->components - e.before->components,
                         e.after->tunnels - e.before->tunnels, e.after->voids - e.before->voids};
        };
        const Betti had = added(event), expected = added(wanted);
        if (had == expected) return true;
        tell(fmt::format("betti: {} {} adds ({}, {}, {}) to components, tunnels and voids, "
                         "expected ({}, {}, {})",
                         name(event.kind), place(event), had.components, had.tunnels, had.voids,
                         expected.components, expected.tunnels, expected.voids));
        return false;
    }

    template<class Tell>
    bool same_time_or_told(const Event& wanted, const Event& event, Tell&& tell) {
        if (wanted.time == event.time) return true;
        if (least_distance(wanted.time, event.time) > dt_) {
            const double by = mid(event.time) - mid(wanted.time);
            tell(fmt::format("moved: {} {}, expected at frame {}: {:+.3g} s, {:+.3g} frames",
                             name(event.kind), place(event), frame_of(wanted.time), by,
                             by * double(fps_.numerator) / double(fps_.denominator)));
            return false;
        }
        if (most_distance(wanted.time, event.time) <= dt_) return true;
        doubt(fmt::format("{} {}: its time is known to {:.2g} s, expected to {:.2g} s; that does "
                          "not tell a move of {:.2g} s",
                          name(event.kind), place(event), formula::width(event.time),
                          formula::width(wanted.time), dt_));
        return false;
    }

    void missing(const Event& event) {
        const std::string line = fmt::format("missing: {} {}", name(event.kind), place(event));
        const bool searched = formula::contains(found_.range, event.time);
        if (event.is_proved && found_.is_proved && found_.doubts.empty() && searched) {
            differ(line);
        } else {
            doubt("not found: " + line.substr(9));
        }
    }
    void extra(const Event& event) {
        const std::string line = fmt::format("extra: {} {}", name(event.kind), place(event));
        const bool inside = formula::contains(expected_.range, event.time);
        if (event.is_proved && expected_.is_proved && expected_.doubts.empty() && inside) {
            differ(line);
        } else {
            doubt("not proved to differ: " + line);
        }
    }

    // Of events that have a kind only together, as many must be of each.
    void compare_moments() {
        while (!together_.empty()) {
            const Event &wanted = *together_.front().first, &event = *together_.front().second;
            const auto end = together_.end();
            const auto rest = std::stable_partition(together_.begin(), end, [&](const auto& pair) {
                return !are_interchangeable(*pair.first, wanted);
            });
            int expected = 0, had = 0;
            bool certain = true;
            for (auto it = rest; it != end; ++it) {
                expected += it->first->kind == wanted.kind;
                had += it->second->kind == wanted.kind;
                certain = certain && it->first->is_proved && it->second->is_proved;
            }
            together_.erase(rest, end);
            if (had == expected) continue;
            const std::string line =
                fmt::format("kind: {} of events that are not told apart {}, expected {}",
                            counted(had, wanted.kind), place(event), expected);
            certain ? differ(line) : doubt("not proved: " + line);
        }
    }

    void compare_ends() {
        const Steps expected = steps_of(expected_), found = steps_of(found_);
        for (const auto& [where, time] :
             {std::pair{"start", expected_.range.lo}, std::pair{"end", expected_.range.hi}}) {
            const Step* wanted = expected.at(time);
            const Step* had = found.at(std::clamp(time, found_.range.lo, found_.range.hi));
            if (!wanted || !wanted->solid || !had || !had->solid) continue; // told as a gap
            if (*wanted->solid == *had->solid) continue;
            const std::string line = fmt::format("betti: at the {}, frame {}: {}; expected {}",
                                                 where, frame_text(frame_at(fps_, time)),
                                                 in_words(*had->solid), in_words(*wanted->solid));
            wanted->is_proved && had->is_proved ? differ(line) : doubt("not proved: " + line);
        }
    }

    const Timeline& expected_;
    const Timeline& found_;
    animation::FrameRate fps_;
    double dt_, span_, diagonal_, same_place_ = 0;
    Check check_;
    std::vector<std::size_t> wanted_, there_; // not matched yet
    // Pairs that may have changed kinds with others of their moments.
    std::vector<std::pair<const Event*, const Event*>> together_;
};

} // namespace

Check compare(const TimelineRecord& expected, const TimelineRecord& found, double dt) {
    return Comparison(expected, found, dt).run();
}

} // namespace isomotion::topology
