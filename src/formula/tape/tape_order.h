// The order of a tape's steps, which decides how many registers an interpreter needs.
#pragma once

#include <vector>

#include "formula/tape/tape.h"

namespace isomotion::formula {

// The same function with its steps in an order that keeps few values at a time. Where that keeps
// many, cheap steps are repeated. `for_values`: the steps that outputs need which are no slopes.
Tape with_slopes_next_to_values(const Tape& tape, const std::vector<bool>& for_values);

} // namespace isomotion::formula
