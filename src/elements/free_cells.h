// Finds how far around each cell of a grid F has no root, and how far there is no element.
#pragma once

#include "elements/cell_lists.h"
#include "elements/element_grid.h"

namespace isomotion::elements {

// Takes a grid with its lists and the sums of its cells. Along axes on which no element depends the
// grid has one cell. If F reads the place, the grid gets more cells there, which share one list.
void find_free_cells(ElementGrid& grid, const Region& region, const CellSums& sums,
                     const RootFree& root_free, const glm::bvec3& is_flat,
                     const GridLimits& limits);

} // namespace isomotion::elements
