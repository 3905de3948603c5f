// The proof of one critical point: Newton's method from the middle of a box, then Krawczyk's
// operator on the box inflated around the limit.
#pragma once

#include <optional>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

struct CriticalPoint {
    Box where; // holds the point
    Box alone; // holds no other one; `where` is inside
    Jet<formula::Interval> jet;
};

// The one critical point in a box around `box`, a little larger (CriticalPoint::alone), which may
// lie in the margin; empty where there is no such proof. Inflation makes roots on the faces between
// boxes harmless. `enclosures` and `numbers` are the field's.
std::optional<CriticalPoint> isolate(const MovingField& field, Enclosures& enclosures,
                                     Numbers& numbers, const Box& box);

} // namespace isomotion::topology
