// The [material] of a scene: how its surface reflects light.
#pragma once

#include "scene/reading/paint.h"
#include "scene/reading/surface.h"

namespace isomotion::scene {

// Reads the section and adds its tracks. Colours that the scene leaves out come from the catalogue;
// a model and its values only from the scene. Sets `painted` to the contents of
// [material.colormap], for make_paint().
Material read_material(Section& document, const SurfaceParts& parts, TrackTable& tracks,
                       std::optional<PaintParts>& painted);

} // namespace isomotion::scene
