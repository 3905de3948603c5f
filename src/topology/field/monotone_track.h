// One track as a function of time, in pieces that rise or fall. Finds the times at which it has a
// value.
//
// Where a track rests for a moment on its way, as tracks with `smooth` do at each key, its rate is
// 0 and proves no crossing. But between successive keys whose values rise, or fall, the track
// rises, or falls, whatever its rate: smoothstep and lines are strictly monotone.
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
    MonotoneTrack(const scene::OneSurface& one, int track, formula::Interval range);

    // Encloses all values of the track, within about 1e-3 of their range.
    formula::Interval values() const;

    struct Time {
        formula::Interval at;
        int direction = 0; // 1: the track rises, -1: it falls, 0: unknown, and so is whether it has
                           // the value there
    };
    // The times with a value in `value`, ascending. A time with a direction holds one time for each
    // member of `value` and lies inside the range. Times without a direction may be long: spans in
    // which the track rests, or hardly moves.
    std::vector<Time> times(formula::Interval value) const;

private:
    struct Piece {
        formula::Interval range;
        formula::Program value, rate;
    };

    // Successive keys through which the track rises, or falls, with times within the range.
    struct Run {
        formula::Interval range;
        int direction = 0;
    };
    static std::vector<Run> runs_of(const animation::Keys& keys, formula::Interval range);
    formula::Interval at(double time) const;
    // The time in the run with the value, if the track's values at the two ends are on different
    // sides of it.
    std::optional<formula::Interval> crossing(const Run& run, formula::Interval value) const;
    void settle_in_runs(std::vector<Time>& times, formula::Interval value) const;

    // The times for a part of the piece, if halving it would tell no more. They may be empty.
    std::optional<Time> settled(const Piece& piece, formula::Interval t,
                                formula::Interval value) const;
    // Proves that a time with a direction holds the value, and that no other time in `between`
    // does.
    bool crosses(const Time& time, formula::Interval value, formula::Interval between) const;

    std::vector<Piece> pieces_;
    std::vector<Run> runs_;
    formula::Bindings<formula::Interval> bindings_;
    formula::Interval range_;
};

} // namespace isomotion::topology
