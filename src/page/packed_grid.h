// Grids of elements as a page keeps them: src/elements/element_grid.h without the lists, which take
// most of the room and follow from where each element is.
//
// Packed, a grid is:
//   a bit a cell, x fastest: 1 if F has no root there;
//   of each element the first and the last cell of the block that it matters in, three bytes each,
//   x, y, z (of one that matters nowhere, 1 and 0 in all), and a bit a cell of the block, x
//   fastest: 1 if it matters there.
// Bits begin with the lowest of a byte, and each run of them with a new byte. Where the grid lies
// is in the block Parameters. web/grid.js unpacks it.
#pragma once

#include <cstddef>
#include <vector>

#include "elements/element_grid.h"

namespace isomotion::page {

// `elements`: of the array.
void pack(const elements::ElementGrid& grid, int elements, std::vector<std::byte>& into);

} // namespace isomotion::page
