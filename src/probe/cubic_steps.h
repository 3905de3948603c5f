// How long steps of cubics may be in a scene: formula/cubic_steps.h at frames that tell most.
#pragma once

#include "formula/cubic_steps.h"
#include "formula/smoothness.h"
#include "scene/scene_at.h"

namespace isomotion::probe {

// Looks at frames evenly apart, and where no array moves, at those at which a parameter of the
// formula is least and largest; `first` is the first frame.
formula::CubicSteps cubic_steps(const scene::OneSurface& one, const formula::Smoothness& smoothness,
                                const scene::SurfaceAt& first);

} // namespace isomotion::probe
