// Reads where a surface is: the bounds that clip its rays, and its transform to the world.
#pragma once

#include "scene/reading/surface.h"

namespace isomotion::scene {

// Reads the surface's bounds and transform. Their tracks follow those of the parameters.
void read_space(Section& document, SurfaceParts& parts, TrackTable& tracks);

} // namespace isomotion::scene
