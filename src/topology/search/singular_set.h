// What an unresolved critical point is part of: a singular point that stays, a curve of them.
//
// A reason for people. It is told from doubles, and no proof rests on it.
#pragma once

#include <optional>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

struct SingularSet {
    int dimension = 0;  // at one moment: 0 of points, 1 of curves, 2 of surfaces
    bool lasts = false; // there is one at other times, too
};

// The set in or near the box on which F and its derivatives along the free coordinates are 0, or so
// near it that F as good as rests there. None where no point of it is found.
std::optional<SingularSet> singular_set(const MovingField& field, const Box& box);

} // namespace isomotion::topology
