// How long steps of cubic marching may be for a formula: the method hermite takes F for the cubic
// through two samples, and measures its error by a third. Where F waves, or has bumps with flat
// ground between them, all three may lie on the ground, and a bump between them is passed unseen.
//
// Steps over the bumps of random lines, and of lines that graze the bodies which those meet, tell
// how long is too long. It chooses steps, and proves nothing.
#pragma once

#include <array>
#include <span>

#include "formula/smoothness.h"

namespace isomotion::formula {

// Parts of the longest step that a ray may take at all.
struct CubicSteps {
    double longest = 1;
    double first = 1; // where a ray begins, and has no third sample

    bool operator==(const CubicSteps&) const = default;
};

// The values of a formula's names at a time, and the box in which it is drawn then.
struct Moment {
    Bindings<double> numbers;
    std::array<Interval, 3> box;
};

// Looks at lines in each of the moments, for cubics whose longest step is `length` in the first of
// them, in proportion to the box in the others, and which take their measured errors `safety`
// times. Takes some times `operations`; of a formula of which a line takes more, it tells nothing.
CubicSteps cubic_steps(const Field& field, const Smoothness& smoothness,
                       std::span<const Moment> moments, double length, double safety = 32,
                       double operations = 1e7);

} // namespace isomotion::formula
