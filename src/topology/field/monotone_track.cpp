#include "topology/field/monotone_track.h"

#include <algorithm>
#include <cmath>

#include "animation/rules.h"
#include "formula/graph/continuity.h"
#include "formula/graph/derivative.h"
#include "topology/field/motion.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

Interval evaluate(const formula::Program& program, const formula::Bindings<Interval>& bindings,
                  Interval t) {
    Interval result;
    formula::Evaluator<Interval>(program).point(bindings, {&t, 1}, {&result, 1});
    return result;
}

// Below this part of the range a turn of the track is not told from a crossing.
constexpr double narrowest = 1e-9;
// Beside a moment of rest at a value, where the track changes with the square of the time, rounding
// hides what it does for about this part of the range.
constexpr double hidden_by_rounding = 0x1p-26;
// With more parts of a piece than this undecided, they stay so: the track nearly rests.
constexpr std::size_t most_open = 1 << 14;
// Newton's steps close in on a crossing where rates differ by this factor at most.
constexpr double most_uneven = 8;

using Time = MonotoneTrack::Time;

// Doubts that are no further than `gap` from each other are one.
std::vector<Time> with_doubts_joined(const std::vector<Time>& times, double gap) {
    std::vector<Time> joined;
    for (const Time& time : times) {
        const bool are_doubts =
            !joined.empty() && joined.back().direction == 0 && time.direction == 0;
        if (are_doubts && time.at.lo - joined.back().at.hi <= gap) {
            joined.back().at = hull(joined.back().at, time.at);
        } else {
            joined.push_back(time);
        }
    }
    return joined;
}

} // namespace

MonotoneTrack::MonotoneTrack(const scene::OneSurface& one, int track, Interval range)
    : range_(range) {
    const animation::Animation& animation = one.surface.animation;
    bindings_.seed = animation.seed();
    formula::Graph all;
    animation::Rules used(animation, mid(range), all, all.input(0));
    used.track(track);
    std::vector<double> ends{range.lo};
    for (const animation::Knot& knot : animation::knots(animation, used.used(), range)) {
        ends.push_back(knot.time);
    }
    ends.push_back(range.hi);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        formula::Graph g;
        const formula::NodeId t = g.input(0);
        const double within = ends[k] + (ends[k + 1] - ends[k]) / 2;
        const formula::NodeId value = animation::Rules(animation, within, g, t).track(track);
        g.fold_exactly();
        const formula::NodeId gaps = formula::gaps(g, value);
        const formula::NodeId rate =
            formula::differentiate_inputs(g, value, {g.constant(1)}, formula::Slopes::generalized);
        pieces_.push_back({{ends[k], ends[k + 1]},
                           formula::schedule(g, std::array{g.add(value, gaps)}),
                           formula::schedule(g, std::array{g.add(rate, gaps)})});
    }
    const animation::TrackSource& source = animation.tracks()[std::size_t(track)].source;
    if (const auto* keys = std::get_if<animation::Keys>(&source)) runs_ = runs_of(*keys, range);
}

std::vector<MonotoneTrack::Run> MonotoneTrack::runs_of(const animation::Keys& keys,
                                                       Interval range) {
    std::vector<Run> runs;
    if (keys.ease != animation::Ease::smooth && keys.ease != animation::Ease::linear) return runs;
    for (std::size_t k = 0; k + 1 < keys.keys.size(); ++k) {
        const animation::Key &a = keys.keys[k], &b = keys.keys[k + 1];
        const int direction = a.value < b.value ? 1 : a.value > b.value ? -1 : 0;
        const Interval within = intersect({a.time, b.time}, range);
        if (direction == 0 || is_empty(within)) continue;
        if (!runs.empty() && runs.back().direction == direction &&
            runs.back().range.hi == within.lo) {
            runs.back().range.hi = within.hi;
        } else {
            runs.push_back({within, direction});
        }
    }
    return runs;
}

Interval MonotoneTrack::at(double time) const {
    const auto piece = std::ranges::find_if(
        pieces_, [&](const Piece& candidate) { return contains(candidate.range, time); });
    return evaluate(piece->value, bindings_, Interval(time));
}

std::optional<Interval> MonotoneTrack::crossing(const Run& run, Interval value) const {
    const auto is_before = [&](double time) {
        const Interval here = at(time);
        return run.direction > 0 ? here.hi < value.lo : here.lo > value.hi;
    };
    const auto is_after = [&](double time) {
        const Interval here = at(time);
        return run.direction > 0 ? here.lo > value.hi : here.hi < value.lo;
    };
    if (!is_before(run.range.lo) || !is_after(run.range.hi)) return std::nullopt;
    // The last time that is known to be before it, and the first that is known to be after.
    const auto last_before = [&](double from, double to) {
        for (double m = mid(Interval(from, to)); from < m && m < to; m = mid(Interval(from, to)))
            (is_before(m) ? from : to) = m;
        return from;
    };
    const auto first_after = [&](double from, double to) {
        for (double m = mid(Interval(from, to)); from < m && m < to; m = mid(Interval(from, to)))
            (is_after(m) ? to : from) = m;
        return to;
    };
    const double before = last_before(run.range.lo, run.range.hi);
    return Interval{before, first_after(before, run.range.hi)};
}

// Settles times without a direction where a run tells more of them.
void MonotoneTrack::settle_in_runs(std::vector<Time>& times, Interval value) const {
    for (const Run& run : runs_) {
        const auto is_in_run = [&](const Time& time) {
            return run.range.lo < time.at.lo && time.at.hi < run.range.hi;
        };
        const auto is_open = [&](const Time& time) {
            return time.direction == 0 && is_in_run(time);
        };
        const auto first = std::ranges::find_if(times, is_open);
        if (first == times.end()) continue;
        const auto only = crossing(run, value);
        if (!only) continue;
        *first = {*only, run.direction};
        // It is the only one in the run.
        times.erase(std::remove_if(std::next(first), times.end(), is_in_run), times.end());
        times.erase(std::remove_if(times.begin(), first, is_in_run), first);
    }
}

Interval MonotoneTrack::values() const {
    constexpr int parts = 1024;
    Interval all;
    bool first = true;
    for (const Piece& piece : pieces_) {
        const double step = (piece.range.hi - piece.range.lo) / parts;
        for (int k = 0; k < parts; ++k) {
            const Interval t(piece.range.lo + k * step,
                             k + 1 < parts ? piece.range.lo + (k + 1) * step : piece.range.hi);
            const Interval value = evaluate(piece.value, bindings_, t);
            all = first ? value : hull(all, value);
            first = false;
        }
    }
    return all;
}

std::optional<MonotoneTrack::Time> MonotoneTrack::settled(const Piece& piece, Interval t,
                                                          Interval value) const {
    const Interval all = evaluate(piece.value, bindings_, t);
    const Interval rate = evaluate(piece.rate, bindings_, t);
    // Where the rate has no bound there may be a pole, across which no mean value leads.
    const bool runs = (rate.lo > 0 || rate.hi < 0) && std::isfinite(magnitude(rate));
    const double m = mid(t);
    const bool is_narrow = !(width(t) > narrowest * width(range_)) || !(t.lo < m && m < t.hi);
    // Parts of a span in which the track rests tell no more than the whole of it.
    const double noise = width(evaluate(piece.value, bindings_, Interval(m)));
    const bool rests = contains(value, all) || magnitude(rate) * width(t) <= noise;
    const bool is_even = runs && magnitude(rate) <= most_uneven * mignitude(rate);
    if (!is_even && !is_narrow && !rests) return std::nullopt;
    if (!runs) return Time{t, 0};
    // Newton's steps keep every time with a value in `value`.
    for (int k = 0; k < 60 && !is_empty(t); ++k) {
        const double from = mid(t);
        const Interval off = value - evaluate(piece.value, bindings_, Interval(from));
        const Interval next =
            intersect(t, Interval(from) + off / evaluate(piece.rate, bindings_, t));
        const bool shrinks = is_empty(next) || width(next) < 0.9 * width(t);
        t = next;
        if (!shrinks) break;
    }
    return Time{t, rate.lo > 0 ? 1 : -1};
}

std::vector<MonotoneTrack::Time> MonotoneTrack::times(Interval value) const {
    std::vector<Time> found;
    for (const Piece& piece : pieces_) {
        std::vector<Interval> open{intersect(with_ends_in_doubt(piece.range), range_)};
        while (!open.empty()) {
            std::vector<Interval> halves;
            const bool are_too_many = open.size() > most_open;
            for (const Interval t : open) {
                if (is_empty(intersect(evaluate(piece.value, bindings_, t), value))) continue;
                if (const auto time = settled(piece, t, value)) {
                    if (!is_empty(time->at)) found.push_back(*time);
                } else if (are_too_many) {
                    found.push_back({t, 0});
                } else {
                    halves.emplace_back(t.lo, mid(t));
                    halves.emplace_back(mid(t), t.hi);
                }
            }
            open = std::move(halves);
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Time& a, const Time& b) { return a.at.lo < b.at.lo; });
    // Pieces that touch have one doubt, or one crossing seen from both sides.
    std::vector<Time> times;
    for (const Time& time : found) {
        if (times.empty() || time.at.lo > times.back().at.hi) {
            times.push_back(time);
            continue;
        }
        Time& last = times.back();
        last.at = hull(last.at, time.at);
        if (last.direction != time.direction) last.direction = 0;
    }
    // At an end of the range a crossing may be inside or outside.
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double after = k > 0 ? times[k - 1].at.hi : range_.lo;
        const double before = k + 1 < times.size() ? times[k + 1].at.lo : range_.hi;
        if (times[k].direction != 0 && !crosses(times[k], value, {after, before}))
            times[k].direction = 0;
    }
    settle_in_runs(times, value);
    return with_doubts_joined(times, hidden_by_rounding * width(range_));
}

// That the track is on one side of the value somewhat before and on the other somewhat after. Near
// a turn enclosures are too wide to tell a value that is reached from one that nearly is.
bool MonotoneTrack::crosses(const Time& time, Interval value, Interval between) const {
    if (!(between.lo < time.at.lo && time.at.hi < between.hi)) return false;
    constexpr int most_doublings = 60;
    double off = std::max(width(time.at), 1e-15 * width(range_));
    for (int k = 0; k < most_doublings; ++k, off *= 2) {
        const double from = time.at.lo - off, to = time.at.hi + off;
        if (!(between.lo < from && to < between.hi)) return false;
        const Interval first = at(from), last = at(to);
        if (time.direction > 0 && first.hi < value.lo && value.hi < last.lo) return true;
        if (time.direction < 0 && last.hi < value.lo && value.hi < first.lo) return true;
    }
    return false;
}

} // namespace isomotion::topology
