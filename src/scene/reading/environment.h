// Reads the [environment] of a scene: distant light as a map of all directions.
#pragma once

#include "base/confines.h"
#include "scene/reading/document.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// Reads the section, if there is one, and adds its tracks. Call it after read_output. Looks for the
// map beside the scene, then in the program's media/. Checks only that the file exists, so a scene
// loads without reading pictures.
std::optional<Environment> read_environment(Section& document, TrackTable& tracks,
                                            const base::Confines& within);

} // namespace isomotion::scene
