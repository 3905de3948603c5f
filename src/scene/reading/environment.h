// The [environment] of a scene: light from far away, as a map of all directions.
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/reach.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// Reads the section, if there is one, and adds its tracks; comes after read_output. The map is
// looked for beside the scene, then in the program's media/. That it is there is all that is
// checked: a scene loads without reading pictures.
std::optional<Environment> read_environment(Section& document, TrackTable& tracks, Reach reach);

} // namespace isomotion::scene
