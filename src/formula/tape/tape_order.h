// The order of a tape's steps, which decides how many registers an interpreter needs.
#pragma once

#include <vector>

#include "formula/tape/tape.h"

namespace isomotion::formula {

// The steps that outputs need which are no slopes. `is_slope`: of each output.
std::vector<bool> steps_of_values(const Tape& tape, const std::vector<bool>& is_slope);

// The same function with its steps in an order that keeps few values at a time. Where that keeps
// many, cheap steps are repeated.
Tape in_short_order(const Tape& tape, const std::vector<bool>& is_slope);

} // namespace isomotion::formula
