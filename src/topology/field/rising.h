// A direction along which all of several functions rise.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "topology/field/jet.h"

namespace isomotion::topology {

// A d with <d, g> > 0 for all g in all of these boxes of gradients, so that 0 is in no hull of such
// g. Uses only `free` components; the others of d are 0. The candidate is the point of the hull of
// the boxes' middles that is nearest to 0, or a direction along an axis; intervals prove it.
std::optional<Point> rising_direction(std::span<const Box> gradients,
                                      std::span<const std::size_t> free);

} // namespace isomotion::topology
