// Bounds on terms that may be left out, so that all that is left out of a sum stays small.
#pragma once

#include <span>
#include <vector>

#include "elements/element_terms.h"

namespace isomotion::elements {

// The part that lists may leave out of a sum, relative to the sum's size where F is 0. Float32
// loses as much when it adds up some twenty terms.
inline constexpr double part_left_out = 0x1p-19;

struct Tolerances {
    std::vector<double> of_term; // for each sum
    std::vector<double> of_sum;  // a bound of the part that is left out of it anywhere
};

// `allowed` is for each sum. Elements are counted by their place, since distant ones have terms far
// below the tolerance. All quadrics must have centres.
Tolerances tolerances(const ElementTerms& terms, std::span<const double> allowed, double widest);

} // namespace isomotion::elements
