// A frame's solid on a grid, by numbers: fast, and no proof.
#pragma once

#include "scene/scene_at.h"
#include "topology/betti/sign_grid.h"
#include "topology/field/solid.h"

namespace isomotion::topology {

// Vertices from one corner of the bounds' box to the other, `side` (at least 2) in each direction.
// No vertex outside of the bounds is solid, and none where F is 0 or no number. `threads`: 0 for as
// many as the machine runs at once.
SignGrid frame_signs(const formula::Field& field, const formula::Bindings<double>& bindings,
                     const scene::BoundsAt& bounds, Side solid, int side, int threads = 0);

} // namespace isomotion::topology
