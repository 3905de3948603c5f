// Functions that are composed of others. Their names stay free: a scene may have a parameter or an
// array field `step`, and in its formulas that is the name's meaning.
#pragma once

#include <span>

#include "formula/graph/functions.h"

namespace isomotion::formula {

std::span<const Function> composed_functions();

} // namespace isomotion::formula
