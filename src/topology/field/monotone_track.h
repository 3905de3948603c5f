// One track as a function of time, in pieces that rise or fall: the times at which it has a value.
//
// Where a track rests for a moment on its way, as keys with `smooth` do at each key, its rate is 0
// there and proves no crossing. But between keys whose values rise, or fall, one after the other it
// does so itself, whatever its rate: smoothstep and lines are strictly monotone.
#pragma once

#include <optional>
#include <vector>

#include "animation/keys.h"
#include "formula/evaluate/evaluate.h"
#include "formula/interval/interval.h"
#include "scene/scene.h"

namespace isomotion::topology {

class MonotoneTrack {
public:
    MonotoneTrack(const scene::Scene& scene, int track, formula::Interval range);

    // All values that the track takes, within about 1e-3 of their range.
    formula::Interval values() const;

    struct Time {
        formula::Interval at;
        int direction = 0; // 1: the track rises, -1: it falls, 0: unknown, and whether it has the
                           // value there is too
    };
    // The times with a value in `value`: those with a direction hold one time for each of its
    // members and lie inside the range. Those without may be long: spans in which the track rests,
    // or hardly moves. Ascending.
    std::vector<Time> times(formula::Interval value) const;

private:
    struct Piece {
        formula::Interval range;
        formula::Program value, rate;
    };

    // Keys one after the other through which the track rises, or falls; their times within the
    // range.
    struct Run {
        formula::Interval range;
        int direction = 0;
    };
    static std::vector<Run> runs_of(const animation::Keys& keys, formula::Interval range);
    formula::Interval at(double time) const;
    // The time in the run with the value, if the track is beyond it at both ends.
    std::optional<formula::Interval> crossing(const Run& run, formula::Interval value) const;
    void settle_in_runs(std::vector<Time>& times, formula::Interval value) const;

    // The times of a part of the piece, if halves of it would tell no more; they may be empty.
    std::optional<Time> settled(const Piece& piece, formula::Interval t,
                                formula::Interval value) const;
    // Proves that a time with a direction is one with the value; no other is in `between`.
    bool crosses(const Time& time, formula::Interval value, formula::Interval between) const;

    std::vector<Piece> pieces_;
    std::vector<Run> runs_;
    formula::Bindings<formula::Interval> bindings_;
    formula::Interval range_;
};

} // namespace isomotion::topology
