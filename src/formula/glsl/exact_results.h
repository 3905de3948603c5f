// Which results of a program on intervals are to be exact where their operands are numbers.
#pragma once

#include <vector>

#include "formula/graph/program.h"

namespace isomotion::formula {

// For each register: whether it holds a sum, product or quotient on which it depends where floor or
// sign jumps, and which may be one number over some boxes, as floor(x)/2 and x*max(0, y) are.
// Bounds about such a number would let the operation seem to jump all over a region.
std::vector<bool> exact_results(const Program& program);

} // namespace isomotion::formula
