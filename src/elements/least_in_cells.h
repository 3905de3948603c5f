// Shortens the lists of a grid for a `least`.
#pragma once

#include "elements/element_grid.h"
#include "elements/element_terms.h"

namespace isomotion::elements {

// Leaves out of long lists the elements that are the least nowhere in their cell: by intervals,
// some other element of the list has a smaller key everywhere in it. So the least at each place
// stays, and each list keeps an element. The outermost cells count as twice as wide, as places
// beyond the grid belong to them. Where lists stay long, cells are divided along the axes that
// aren't flat, as few elements may be the least in a small cell. Leaves grids alone whose cells
// share lists.
void keep_possible_least(ElementGrid& grid, const Region& region, const ElementTerms& terms,
                         const glm::bvec3& is_flat, const GridLimits& limits);

} // namespace isomotion::elements
