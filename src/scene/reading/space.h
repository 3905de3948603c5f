// Where a surface is: the bounds that its rays are clipped to, and its placement in the world.
#pragma once

#include "scene/reading/surface.h"

namespace isomotion::scene {

// Reads what the surface's bounds and placement are; the tracks of these come after the parameters.
void read_space(Section& document, SurfaceParts& parts, TrackTable& tracks);

} // namespace isomotion::scene
