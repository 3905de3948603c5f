// Reads where a surface is: the bounds that clip its rays, and its transform to the world.
#pragma once

#include "scene/reading/surface.h"

namespace isomotion::scene {

// Reads the bounds and the transform of [surface]. Their tracks follow those of the parameters.
// Without bounds there are tracks of a ball that is as large as bounds are looked for.
void read_space(Section& surface, SurfaceParts& parts, TrackTable& tracks);

} // namespace isomotion::scene
