#include "topology/timeline/compare.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "topology/timeline/contradictions.h"
#include "topology/timeline/event_differences.h"
#include "topology/timeline/matching.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

std::string solids_text(const std::vector<int>& solids) {
    std::string text;
    for (const int sign : solids)
        text += fmt::format("{}{}", text.empty() ? "" : " and ", solid_text(sign));
    return text;
}

class Comparison {
public:
    Comparison(const TimelineRecord& expected, const TimelineRecord& found, double dt)
        : expected_(expected.timeline)
        , found_(found.timeline)
        , fps_(found.header.fps)
        , dt_(dt)
        , tolerance_(tolerance_of(found, dt))
        , diagonal_(diagonal(found.header)) {
        const double searched = formula::width(found_.range);
        if (searched > 0) span_ = searched;
        if (expected.header.fingerprint != found.header.fingerprint) {
            check_.notes.emplace_back("the scene is not the one that the expectation was made of");
        }
        const TimelineHeader &one = expected.header, &other = found.header;
        if (one.shape != other.shape || one.start_bounds != other.start_bounds ||
            one.end_bounds != other.end_bounds) {
            check_.notes.emplace_back("the bounds are not those of the expectation");
        }
        if (!one.solids.empty() && !other.solids.empty() && one.solids != other.solids) {
            differ(fmt::format("solid: {}, expected {}; --solid chooses the side of F",
                               solids_text(other.solids), solids_text(one.solids)));
        }
        if (one.fps != other.fps) {
            check_.notes.emplace_back("the frame rate is not the expectation's; times are compared "
                                      "in seconds");
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
        tell_contradictions();
        return std::move(check_);
    }

private:
    void differ(std::string line) { check_.differences.push_back(std::move(line)); }
    void doubt(std::string line) { check_.undecided.push_back(std::move(line)); }

    std::string place(const Event& event) const { return place_text(event, fps_); }
    bool most_inside(Interval time) const {
        return time.hi >= expected_.range.lo - dt_ && time.lo <= expected_.range.hi + dt_;
    }

    void check_range() {
        const Interval wanted = expected_.range, had = found_.range;
        if (formula::contains(had, wanted)) return;
        const auto frame = [&](double time) {
            return fmt::format("{:.12g}", frame_at(fps_, time));
        };
        doubt(fmt::format("searched were frames {} to {}, expected are events of {} to {}",
                          frame(had.lo), frame(had.hi), frame(wanted.lo), frame(wanted.hi)));
    }
    void tell_gaps() {
        for (const std::string& reason : gaps(found_, fps_)) doubt("found: " + reason);
        for (const std::string& reason : contradictions(found_, fps_)) {
            doubt("found contradicts itself: " + reason);
        }
        for (const std::string& reason : gaps(expected_, fps_)) {
            doubt("the expectation itself is incomplete: " + reason);
        }
    }

    // Tells where the expectation contradicts itself. It may be right in all that is compared with
    // what was found, and is wrong all the same. Where something differs anyway, only that is told.
    void tell_contradictions() {
        if (!check_.differences.empty()) return;
        for (const std::string& reason : contradictions(expected_, fps_)) {
            differ("the expectation contradicts itself: " + reason);
        }
    }

    bool is_same(const Event& a, const Event& b) const {
        return (a.kind == b.kind || may_change_kinds(a, b)) && a.index == b.index &&
               a.grows == b.grows && a.stratum == b.stratum &&
               least_distance(a.time, b.time) <= dt_ && place_distance(a, b) <= tolerance_.place;
    }

    // Pairs events that are equal: most events of most checks. What is left is matched in more than
    // linear time.
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

    // A file of a stranger's may hold so many that pairing them takes gigabytes and hours.
    static constexpr std::size_t most_pairs = 4'000'000;

    // An item alone costs 1 and says one line. Half of the time and the bounds together is too far
    // for one event; another kind is as bad as an eighth.
    void pair_rest() {
        if (there_.empty()) return;
        if (wanted_.size() > most_pairs / there_.size()) {
            check_.notes.push_back(fmt::format("{} events that are expected and {} that were found "
                                               "are too many to tell which are near each other",
                                               wanted_.size(), there_.size()));
            return;
        }
        const auto cost = [&](std::size_t e, std::size_t f) {
            const Event& a = expected_.events[wanted_[e]];
            const Event& b = found_.events[there_[f]];
            const double apart = least_distance(a.time, b.time) / span_;
            const bool is_alike =
                a.index == b.index && a.grows == b.grows && a.stratum == b.stratum;
            const double kind = a.kind != b.kind ? 0.5 : is_alike ? 0 : 0.25;
            return kind + 4 * (apart + place_distance(a, b) / diagonal_);
        };
        const auto pairs = match(wanted_.size(), there_.size(), cost, 1);
        std::vector<std::size_t> alone;
        std::vector<char> taken(there_.size(), 0);
        for (std::size_t e = 0; e < pairs.size(); ++e) {
            const auto& pair = pairs[e];
            if (!pair) {
                alone.push_back(wanted_[e]);
                continue;
            }
            taken[*pair] = 1;
            paired(expected_.events[wanted_[e]], found_.events[there_[*pair]]);
        }
        std::vector<std::size_t> others;
        for (std::size_t f = 0; f < there_.size(); ++f) {
            if (!taken[f]) others.push_back(there_[f]);
        }
        wanted_ = std::move(alone);
        there_ = std::move(others);
    }

    void paired(const Event& wanted, const Event& event) {
        if (may_change_kinds(wanted, event)) together_.emplace_back(&wanted, &event);
        const auto told = differences(wanted, event, tolerance_, fps_);
        for (const EventDifference& difference : told) {
            difference.is_open ? doubt(difference.line) : differ(difference.line);
        }
        if (told.empty()) ++check_.agreed;
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
        if (least_distance(event.time, expected_.range) > 0) return; // it was there to be matched
        const std::string line = fmt::format("extra: {} {}", name(event.kind), place(event));
        const bool inside = formula::contains(expected_.range, event.time);
        if (event.is_proved && expected_.is_proved && expected_.doubts.empty() && inside) {
            differ(line);
        } else {
            doubt("not proved to differ: " + line);
        }
    }

    // Compares events that have a kind only together: there must be as many of each kind.
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

    struct Numbers {
        std::optional<Betti> solid;
        bool is_proved = false;
        std::string_view why = "not known"; // where there is none
    };
    // The numbers that were found at an end of the search, or else those that hold between two
    // events.
    Numbers found_at(double time, bool is_start, const Steps& steps) const {
        if (is_start && time == found_.range.lo) return {found_.start, found_.start_is_proved};
        if (!is_start && time == found_.range.hi) return {found_.end, found_.end_is_proved};
        if (const Step* step = steps.at(time)) return {step->solid, step->is_proved};
        return {{}, false, "not known; it is within the enclosure of an event's time"};
    }
    void compare_ends() {
        const Steps steps = steps_of(found_);
        for (const bool is_start : {true, false}) {
            const Interval range = expected_.range;
            const double time = is_start ? range.lo : range.hi;
            const auto& wanted = is_start ? expected_.start : expected_.end;
            // Both are told already.
            if (!wanted || !formula::contains(found_.range, time)) continue;
            compare_end(fmt::format("betti: at the {}, frame {}", is_start ? "start" : "end",
                                    frame_text(frame_at(fps_, time))),
                        *wanted, is_start ? expected_.start_is_proved : expected_.end_is_proved,
                        found_at(time, is_start, steps));
        }
    }
    void compare_end(const std::string& where, const Betti& wanted, bool is_proved,
                     const Numbers& had) {
        if (!had.solid) {
            doubt(fmt::format("{}: {}; expected {}", where, had.why, in_words(wanted)));
        } else if (*had.solid != wanted) {
            const std::string line =
                fmt::format("{}: {}; expected {}", where, in_words(*had.solid), in_words(wanted));
            is_proved&& had.is_proved ? differ(line) : doubt("not proved: " + line);
        } else if (!had.is_proved) {
            doubt(fmt::format("{}: {}, but that is not proved", where, in_words(wanted)));
        }
    }

    const Timeline& expected_;
    const Timeline& found_;
    animation::FrameRate fps_;
    double dt_;
    Tolerance tolerance_;
    double diagonal_, span_ = 1; // of all that was searched: what is far is measured by them
    Check check_;
    std::vector<std::size_t> wanted_, there_; // not matched yet
    // Pairs that may have changed kinds with others of their moments.
    std::vector<std::pair<const Event*, const Event*>> together_;
};

} // namespace

Check compare(const TimelineRecord& expected, const TimelineRecord& found, double dt) {
    if (!(dt >= 0) || !std::isfinite(dt)) {
        throw std::invalid_argument(
            fmt::format("events cannot have moved by up to {} s; give seconds from 0 on", dt));
    }
    return Comparison(expected, found, dt).run();
}

} // namespace isomotion::topology
