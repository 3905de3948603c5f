// Proves one critical point: Newton's method from the middle of a box, then Krawczyk's operator on
// the box inflated around the limit.
#pragma once

#include <optional>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

struct CriticalPoint {
    Box where; // contains the point
    Box alone; // contains no other point; `where` is inside it
    Jet<formula::Interval> jet;
};

// The one critical point in a slightly larger box around `box` (CriticalPoint::alone); the point
// may lie in the margin. Empty if there is no such proof. Inflation handles roots on the faces
// between boxes. `enclosures` and `numbers` are the field's.
std::optional<CriticalPoint> isolate(const MovingField& field, Enclosures& enclosures,
                                     Numbers& numbers, const Box& box);

} // namespace isomotion::topology
