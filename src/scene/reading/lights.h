// Reads [[lights]], [ground], [fog], [ambient] and [occlusion].
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

void read_lights(Section& document, Scene& scene, TrackTable& tracks);
void read_surroundings(Section& document, Scene& scene, TrackTable& tracks);

} // namespace isomotion::scene
