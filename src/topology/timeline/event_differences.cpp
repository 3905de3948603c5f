#include "topology/timeline/event_differences.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// The distance between the farthest members.
double most_distance(Interval a, Interval b) { return std::max(a.hi - b.lo, b.hi - a.lo); }

template<class Distance> double distance(const Event& a, const Event& b, Distance&& along) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += std::pow(along(a.where[k], b.where[k]), 2);
    return std::sqrt(sum);
}

std::string_view stratum_text(int stratum) {
    constexpr std::string_view texts[] = {"at a corner", "on an edge", "on a face", "inside"};
    return texts[std::clamp(stratum, 0, 3)];
}

std::string_view direction_text(bool grows) { return grows ? "grows" : "shrinks"; }

class EventComparison {
public:
    EventComparison(const Event& wanted, const Event& event, const Tolerance& tolerance,
                    animation::FrameRate fps)
        : wanted_(wanted)
        , event_(event)
        , tolerance_(tolerance)
        , fps_(fps)
        , what_(fmt::format("{} {}", name(event.kind), place_text(event, fps))) {}

    std::vector<EventDifference> run() {
        compare_kinds();
        if (compare_times()) compare_places();
        if (wanted_.is_proved_again && !event_.is_proved_again) {
            doubt(fmt::format("{}: was proved again by another arithmetic, and is not", what_));
        }
        return std::move(found_);
    }

private:
    void tell(std::string line) {
        if (wanted_.is_proved && event_.is_proved) {
            found_.push_back({std::move(line), false});
        } else {
            doubt("not proved: " + std::move(line));
        }
    }
    void doubt(std::string line) { found_.push_back({std::move(line), true}); }

    void compare_kinds() {
        const bool is_together = may_change_kinds(wanted_, event_);
        if (wanted_.kind != event_.kind && !is_together) {
            const std::string line =
                fmt::format("kind: {}, expected {}", what_, name(wanted_.kind));
            const bool is_unknown = wanted_.kind == Kind::unknown || event_.kind == Kind::unknown;
            is_unknown ? doubt(line) : tell(line);
            return; // an index or a direction that differs says the same again
        }
        if (wanted_.stratum != event_.stratum) {
            tell(fmt::format("stratum: {} {}, expected {}", what_, stratum_text(event_.stratum),
                             stratum_text(wanted_.stratum)));
        }
        if (is_together) return; // of one index and one direction, and one number of each kind
        if (wanted_.index != event_.index) {
            tell(fmt::format("index: {} of index {}, expected {}", what_, event_.index,
                             wanted_.index));
        }
        if (wanted_.grows != event_.grows) {
            tell(fmt::format("direction: {} {}, expected that it {}", what_,
                             direction_text(event_.grows), direction_text(wanted_.grows)));
        }
        compare_changes();
        // How a kind was proved may change; that it was proved of this very event may not.
        const bool is_less = event_.kind != Kind::none &&
                             (event_.kind_proof.empty() || event_.kind_proof == "together");
        if (is_less && !wanted_.kind_proof.empty() && wanted_.kind_proof != "together") {
            doubt(fmt::format("kind: {}: that it is this one's kind is not proved", what_));
        }
    }

    // What events of unknown kind add is known where frames about them are.
    void compare_changes() {
        if (!wanted_.before || !wanted_.after || !event_.before || !event_.after) return;
        const auto added = [](const Event& e) {
            return Betti{e.after->components - e.before->components,
                         e.after->tunnels - e.before->tunnels, e.after->voids - e.before->voids};
        };
        const Betti had = added(event_), expected = added(wanted_);
        if (had == expected) return;
        tell(fmt::format("betti: {} adds ({}, {}, {}) to components, tunnels and voids, "
                         "expected ({}, {}, {})",
                         what_, had.components, had.tunnels, had.voids, expected.components,
                         expected.tunnels, expected.voids));
    }

    // Whether they are at one time as far as is known.
    bool compare_times() {
        const Interval wanted = wanted_.time, had = event_.time;
        if (wanted == had) return true;
        if (least_distance(wanted, had) > tolerance_.time) {
            const double by = mid(had) - mid(wanted);
            tell(fmt::format("moved: {}, expected at frame {}: {:+.3g} s, {:+.3g} frames", what_,
                             frame_text(frames_at(fps_, wanted)), by,
                             by * double(fps_.numerator) / double(fps_.denominator)));
            return false;
        }
        if (most_distance(wanted, had) <= tolerance_.time) return true;
        doubt(fmt::format("{}: its time is known to {:.2g} s, expected to {:.2g} s; that does "
                          "not tell a move of {:.2g} s",
                          what_, formula::width(had), formula::width(wanted), tolerance_.time));
        return false;
    }

    void compare_places() {
        if (wanted_.where == event_.where) return;
        if (const double apart = place_distance(wanted_, event_); apart > tolerance_.place) {
            tell(fmt::format("elsewhere: {}, {:.3g} from where it was expected", what_, apart));
        } else if (!(distance(wanted_, event_, most_distance) <= tolerance_.place)) {
            doubt(fmt::format("{}: its place is not known well enough, or not expected precisely "
                              "enough, to tell a move of {:.2g}",
                              what_, tolerance_.place));
        }
    }

    const Event& wanted_;
    const Event& event_;
    const Tolerance& tolerance_;
    animation::FrameRate fps_;
    std::string what_;
    std::vector<EventDifference> found_;
};

} // namespace

double diagonal(const TimelineHeader& header) {
    double sum = 0;
    for (const Interval side : header.start_bounds) sum += std::pow(side.hi - side.lo, 2);
    return std::isfinite(sum) && sum > 0 ? std::sqrt(sum) : 1;
}

Tolerance tolerance_of(const TimelineRecord& found, double dt) {
    const double searched = formula::width(found.timeline.range);
    const double part = searched > 0 ? std::min(dt / searched, 1.0) : 0;
    return {dt, diagonal(found.header) * std::max(1e-6, part)};
}

double least_distance(Interval a, Interval b) { return std::max({0.0, a.lo - b.hi, b.lo - a.hi}); }

double place_distance(const Event& a, const Event& b) { return distance(a, b, least_distance); }

bool may_change_kinds(const Event& a, const Event& b) {
    return a.kind_proof == "together" && b.kind_proof == "together" && a.index == b.index &&
           a.grows == b.grows;
}

std::vector<EventDifference> differences(const Event& wanted, const Event& event,
                                         const Tolerance& tolerance, animation::FrameRate fps) {
    return EventComparison(wanted, event, tolerance, fps).run();
}

std::string place_text(const Event& event, animation::FrameRate fps) {
    return fmt::format("at frame {} ({:.9g} s), near ({:.4g}, {:.4g}, {:.4g})",
                       frame_text(frames_at(fps, event.time)), mid(event.time), mid(event.where[0]),
                       mid(event.where[1]), mid(event.where[2]));
}

} // namespace isomotion::topology
