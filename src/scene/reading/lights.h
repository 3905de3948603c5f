// [[lights]], and the tables of what lights fall on and pass through: [ground], [fog], [occlusion].
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

void read_lights(Section& document, Scene& scene, TrackTable& tracks);
void read_surroundings(Section& document, Scene& scene, TrackTable& tracks);

} // namespace isomotion::scene
