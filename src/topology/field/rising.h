// A direction along which all of some functions rise.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "topology/field/jet.h"

namespace isomotion::topology {

// A d with <d, g> > 0 for all g in all of these boxes of gradients: then 0 is in no hull of such g.
// Only components that are `free` are asked for; the others of d are 0. It is the point of the hull
// of the boxes' middles that is nearest to 0, or along an axis; the proof is by intervals.
std::optional<Point> rising_direction(std::span<const Box> gradients,
                                      std::span<const std::size_t> free);

} // namespace isomotion::topology
