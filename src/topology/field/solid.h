// Which side of a surface is the solid.
#pragma once

#include "scene/scene.h"

namespace isomotion::topology {

enum class Side {
    negative, // {F < 0}
    positive, // {F > 0}: densities less a threshold
};

// The side that the bounds don't touch at the scene's first frame; negative if they touch both. One
// for the scene, not for the span that is searched: timelines of two spans then speak of one solid.
Side solid_side(const scene::Scene& scene);

} // namespace isomotion::topology
