// The frame that moves with a surface best. How good the fit is decides the number of boxes that a
// search takes and nothing else.
#pragma once

#include "topology/field/moving_field.h"

namespace isomotion::topology {

// The frame in which the derivatives of F in space change least where F is near 0: a least-squares
// fit at samples, always the same. It rests where it would explain little of their change. `field`
// has three free coordinates, in a frame that rests.
ComovingFrame fit_comoving_frame(const MovingField& field);

// In the fitted frame where all three coordinates are free; else in one that rests.
MovingField comoving_field(const Motion& motion, const Stratum& stratum);

} // namespace isomotion::topology
