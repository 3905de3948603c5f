// Reads the [camera] of a scene.
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// Reads the section and adds its tracks. Without a position, the camera looks at the bounds.
Camera read_camera(Section& document, TrackTable& tracks);

} // namespace isomotion::scene
