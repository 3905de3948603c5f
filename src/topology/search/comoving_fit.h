// Fits the frame that moves best with a surface. The quality of the fit affects only the number of
// boxes in a search.
#pragma once

#include "topology/field/moving_field.h"

namespace isomotion::topology {

// The frame in which the spatial derivatives of F change least where F is near 0: a deterministic
// least-squares fit at samples. The frame rests if a moving one would explain little of the change.
// `field` must have three free coordinates, in a frame that rests.
ComovingFrame fit_comoving_frame(const MovingField& field);

// In the fitted frame if all three coordinates are free, otherwise in a frame that rests.
MovingField comoving_field(const Motion& motion, const Stratum& stratum);

} // namespace isomotion::topology
