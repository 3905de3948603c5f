// Betti numbers of one frame, proved by a cell complex: for surfaces with edges, corners, needles
// and cones too, and closer to singular points than a grid.
//
// A cell is settled where G has one sign, or where G rises along one direction all over it: the
// solid {G < 0} then sinks against that direction to some of the cell's facets. Directions are
// sought for all smooth formulas at once that G takes in the cell (pieces.h).
#pragma once

#include "topology/betti/certified_frame.h"

namespace isomotion::topology {

// As certify_frame(), which asks for it where its own method doesn't do. `depth` and `boxes` of the
// limits are not taken.
CertifiedFrame certify_by_cells(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                                const FrameLimits& limits);

} // namespace isomotion::topology
