// What shaders and marches have to know of a surface that its file does not say.
#pragma once

#include "scene/scene_at.h"

namespace isomotion::probe {

// `first`: the surface at the first frame.
scene::Measured measured(const scene::OneSurface& one, const scene::SurfaceAt& first);

} // namespace isomotion::probe
