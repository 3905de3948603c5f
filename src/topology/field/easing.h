// The way between two keys at which everything rests, as a clock: smoothstep, u^2 (3 - 2u) with u
// the part of the time. It rises throughout, though its rate at both keys is 0.
#pragma once

#include "formula/interval/interval.h"

namespace isomotion::topology {

struct Easing {
    double from = 0, to = 1; // times of the keys
    // The time that is searched, between the keys.
    formula::Interval span{0, 1};

    // Holds the parts of the way that are made in these times, all between the keys.
    formula::Interval way(formula::Interval time) const;
    // Holds the times between the keys at which these parts are made.
    formula::Interval time(formula::Interval way) const;
};

} // namespace isomotion::topology
