// A direction along which all of some functions rise.
#pragma once

#include <span>
#include <vector>

#include "topology/field/jet.h"

namespace isomotion::topology {

// Whether some d has <d, g> > 0 for all g in all of these boxes of gradients of `n` components: then
// 0 is in no hull of such g. The direction is the point of the hull of the boxes' middles that is
// nearest to 0, nearly (Gilbert 1966); the proof is by intervals.
bool rise_together(std::span<const Box> gradients, std::size_t n);

} // namespace isomotion::topology
