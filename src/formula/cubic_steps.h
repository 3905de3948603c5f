// How long steps of cubic marching may be for a formula: the method hermite takes F for the cubic
// through two samples, and measures its error by a third. Where F waves, or has bumps with flat
// ground between them, all three may lie on the ground, and a bump between them is passed unseen.
//
// Steps over the bumps of random lines tell how long is too long. It chooses steps, and proves
// nothing.
#pragma once

#include <span>

#include "formula/smoothness.h"

namespace isomotion::formula {

// Parts of the longest step that a ray may take at all.
struct CubicSteps {
    double longest = 1;
    double first = 1; // where a ray begins, and has no third sample

    bool operator==(const CubicSteps&) const = default;
};

// Looks at lines in each of the regions, for a method whose longest step is `length`. Takes a few
// times `operations`; of formulas whose values on a line take more, it tells nothing.
CubicSteps cubic_steps(const Field& field, const Smoothness& smoothness,
                       std::span<const Region> regions, double length, double operations = 1e7);

} // namespace isomotion::formula
