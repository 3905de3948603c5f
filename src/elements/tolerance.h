// How much of a term may be left out, so that all that is left out of a sum stays small.
#pragma once

#include <span>
#include <vector>

#include "elements/element_terms.h"

namespace isomotion::elements {

// What lists leave out of a sum, as a part of what the sum is where F is 0. Float32 loses as much
// when it adds up some twenty terms.
inline constexpr double part_left_out = 0x1p-19;

struct Tolerances {
    std::vector<double> of_term; // of each sum
    std::vector<double> of_sum;  // a bound of what is left out of it anywhere
};

// `allowed` of each sum. Elements are counted where they stand: those far away have terms far below
// the tolerance. All quadrics have middles.
Tolerances tolerances(const ElementTerms& terms, std::span<const double> allowed, double widest);

} // namespace isomotion::elements
