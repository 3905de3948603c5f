// Where a moving surface may reach the sphere that bounds it.
#pragma once

#include <functional>
#include <vector>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

// Boxes that hold all points of the surface on the sphere; none where it provably keeps off. Boxes
// are divided until there are about `most`, or until `stopped`, which is asked often and may be
// empty.
std::vector<Box> on_the_sphere(const MovingField& inside, std::size_t most,
                               const std::function<bool()>& stopped);

} // namespace isomotion::topology
