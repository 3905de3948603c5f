#pragma once

#include "fluid.h"

namespace water {

/// A column of about `particles` particles at one end of a tank of 2 x 1 units with a post: let go,
/// it breaks on the post and at the other end.
Fluid dam_break(int particles, unsigned threads);

/// A ball of water that falls into a round shallow pool, of about `particles` together.
Fluid ball_into_pool(int particles, unsigned threads);

} // namespace water
