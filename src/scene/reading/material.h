// The [material] of a scene: how its surface reflects light.
#pragma once

#include "scene/reading/paint.h"
#include "scene/reading/surface.h"

namespace isomotion::scene {

// Reads the section and adds its tracks. Colours that the scene leaves out are the catalogue's;
// a model and its numbers are the scene's alone.
// `painted` is what [material.colormap] has, for make_paint().
Material read_material(Section& document, const SurfaceParts& parts, TrackTable& tracks,
                       std::optional<PaintParts>& painted);

} // namespace isomotion::scene
