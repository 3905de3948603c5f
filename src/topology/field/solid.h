// The side of a surface that is the solid.
#pragma once

#include "scene/scene.h"

namespace isomotion::topology {

enum class Side {
    negative, // {F < 0}
    positive, // {F > 0}: densities minus a threshold
};

// The side that the bounds don't touch at the scene's first frame; negative if they touch both. It
// depends on the scene, not on the span searched, so timelines of different spans have the same
// solid.
Side solid_side(const scene::OneSurface& one);

} // namespace isomotion::topology
