// One track as a function of time, in pieces that rise or fall: the times at which it has a value.
#pragma once

#include <optional>
#include <vector>

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

    // The times of a part of the piece, if halves of it would tell no more; they may be empty.
    std::optional<Time> settled(const Piece& piece, formula::Interval t,
                                formula::Interval value) const;
    // Proves that a time with a direction is one with the value; no other is in `between`.
    bool crosses(const Time& time, formula::Interval value, formula::Interval between) const;

    std::vector<Piece> pieces_;
    formula::Bindings<formula::Interval> bindings_;
    formula::Interval range_;
};

} // namespace isomotion::topology
