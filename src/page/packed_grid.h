// Grids of elements as a page stores them: those of src/elements/element_grid.h without the lists,
// which take most of the space and follow from each element's cells.
//
// A packed grid is:
//
//   one bit per cell, x fastest: 1 if F has no root there;
//   for each element the first and the last cell of the block that it matters in, three bytes each,
//   x, y, z (1 and 0 in all if it matters nowhere), and one bit per cell of the block, x fastest: 1
//   if it matters there.
//
// Bits start with the lowest of a byte, and each sequence of bits starts a new byte. The block
// Parameters has the grid's place. web/grid.js unpacks it.
#pragma once

#include <cstddef>
#include <vector>

#include "elements/element_grid.h"

namespace isomotion::page {

// `elements`: the number of the array's elements.
void pack(const elements::ElementGrid& grid, int elements, std::vector<std::byte>& into);

} // namespace isomotion::page
