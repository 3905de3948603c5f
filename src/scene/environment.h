// The [environment] of a scene: light from far away, as a map of all directions.
#pragma once

#include "scene/document.h"
#include "scene/reach.h"
#include "scene/scene.h"
#include "scene/track_table.h"

namespace isomotion::scene {

// Reads the section, if there is one, and adds its tracks; comes after read_output. The map is
// looked for beside the scene, then in the program's media/. That it is there is all that is
// checked: a scene loads without reading pictures.
std::optional<Environment> read_environment(Section& document, TrackTable& tracks, Reach reach);

} // namespace isomotion::scene
