// How long steps of cubics may be while sliders hold parameters (probe/cubic_steps.h): a slider may
// make waves shorter than any frame of the scene has them.
#pragma once

#include "scene/scene.h"

namespace isomotion::player {

// A scene with overrides applied, whose surfaces have the steps that their values now ask for.
// Takes some milliseconds a surface.
scene::Scene with_own_steps(scene::Scene scene);

// The shortest steps of a surface over its sliders' ends, one slider after the other.
formula::CubicSteps steps_at_slider_ends(const scene::OneSurface& one);

} // namespace isomotion::player
