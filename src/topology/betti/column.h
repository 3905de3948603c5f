// A column of a grid's vertices along an axis on which a function G is monotone.
#pragma once

#include <algorithm>

#include "formula/interval/interval.h"

namespace isomotion::topology {

// Vertices along an axis on which G is monotone, counted from where it is lowest: the first `solid`
// are in the solid, and the one with number `not_solid` isn't known to be. It becomes known from a
// guess by steps that double, then by halving.
struct Column {
    int solid = 0, not_solid = -1; // -1: not begun
    int guess = 0, step = 0;
    formula::Interval beyond{}; // G at not_solid

    bool is_known() const { return solid == not_solid; }
    int next(int last) const {
        if (step == 0) return std::min(guess, last);
        if (not_solid > last) return std::min(last, solid - 1 + step);
        if (solid == 0) return std::max(0, not_solid - step);
        return (solid + not_solid) / 2;
    }
    void learn(formula::Interval value, int last) {
        const int asked = next(last);
        step = step == 0 ? 1 : 2 * step;
        if (value.hi < 0) {
            solid = asked + 1;
        } else {
            not_solid = asked;
            beyond = value;
        }
    }
};

} // namespace isomotion::topology
