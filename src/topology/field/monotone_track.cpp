#include "topology/field/monotone_track.h"

#include <algorithm>

#include "animation/rules.h"
#include "formula/graph/derivative.h"

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

} // namespace

MonotoneTrack::MonotoneTrack(const scene::Scene& scene, int track, Interval range)
    : range_(range) {
    const animation::Animation& animation = scene.timeline.animation;
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
        const formula::NodeId rate =
            formula::differentiate_inputs(g, value, {g.constant(1)}, formula::Slopes::generalized);
        pieces_.push_back({{ends[k], ends[k + 1]},
                           formula::schedule(g, std::array{value}),
                           formula::schedule(g, std::array{rate})});
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

std::vector<MonotoneTrack::Time> MonotoneTrack::times(Interval value) const {
    std::vector<Time> found;
    const double least = narrowest * (range_.hi - range_.lo);
    for (const Piece& piece : pieces_) {
        std::vector<Interval> stack{piece.range};
        while (!stack.empty()) {
            Interval t = stack.back();
            stack.pop_back();
            if (is_empty(intersect(evaluate(piece.value, bindings_, t), value))) continue;
            const Interval rate = evaluate(piece.rate, bindings_, t);
            const bool runs = rate.lo > 0 || rate.hi < 0;
            if (runs) {
                // Newton's steps keep every time with a value in `value`.
                for (int k = 0; k < 60 && !is_empty(t); ++k) {
                    const double m = mid(t);
                    const Interval off = value - evaluate(piece.value, bindings_, Interval(m));
                    const Interval next =
                        intersect(t, Interval(m) + off / evaluate(piece.rate, bindings_, t));
                    const bool shrinks = is_empty(next) || width(next) < 0.9 * width(t);
                    t = next;
                    if (!shrinks) break;
                }
                if (!is_empty(t)) found.push_back({t, rate.lo > 0 ? 1 : -1});
                continue;
            }
            const double m = mid(t);
            if (!(width(t) > least) || !(t.lo < m && m < t.hi)) {
                found.push_back({t, 0});
                continue;
            }
            stack.emplace_back(t.lo, m);
            stack.emplace_back(m, t.hi);
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Time& a, const Time& b) { return a.at.lo < b.at.lo; });
    // Pieces that touch: one doubt, or one crossing seen from both sides.
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
    for (Time& time : times) {
        if (time.at.lo <= range_.lo || time.at.hi >= range_.hi) time.direction = 0;
    }
    return times;
}

} // namespace isomotion::topology
