// Parts of a formula that do nothing within the bounds.
#pragma once

#include "topology/field/motion.h"

namespace isomotion::topology {

// Leaves the motion's field as it is at all places of the bounds, at all times of its clock.
//
// Where a <= b at all of these, T_n(min(a, b)) becomes T_n(a). cos(n*acos(x)) is T_n(min(1, max(-1,
// x))), and walls often are at x = 1, where the clamp would count as a kink. Beyond the bounds
// polynomials are as smooth; another expression with a clamp might end there.
//
// A quotient has no value where it is 0/0. What adds that to the field asks for absolute values,
// which count as kinks. It is dropped where the divisor, or the dividend, is never 0.
void drop_idle_parts(Motion& motion);

} // namespace isomotion::topology
