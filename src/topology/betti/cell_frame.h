// Proves Betti numbers of one frame by a cell complex. This also works for surfaces with edges,
// corners, needles and cones, and closer to singular points than a grid.
//
// A cell is settled where G has one sign, or where G rises along one direction everywhere in it.
// Then the solid {G < 0} retracts against that direction to some of the cell's facets. Directions
// are sought for all smooth formulas together that G may equal in the cell (pieces.h).
#pragma once

#include "topology/betti/certified_frame.h"

namespace isomotion::topology {

// Certifies as certify_frame() does, which calls this if its own method fails. Ignores `depth` and
// `boxes` of the limits.
CertifiedFrame certify_by_cells(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                                const FrameLimits& limits);

} // namespace isomotion::topology
