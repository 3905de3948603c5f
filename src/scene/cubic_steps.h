// How long steps of cubics may be in a scene: formula/cubic_steps.h at frames that tell most.
#pragma once

#include "formula/cubic_steps.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

// Looks at frames evenly apart, and where no array moves, at those at which a parameter of the
// formula is least and largest. Its smoothness must be known; `first` is the first frame.
formula::CubicSteps cubic_steps(const OneSurface& one, const SurfaceAt& first);

} // namespace isomotion::scene
