// The domain in which a scene evaluates its formula: the box around its bounds, and the ranges of
// its names, over all of its frames.
#pragma once

#include <vector>

#include "formula/smoothness.h"
#include "scene/scene_at.h"

namespace isomotion::probe {

// One region for each pair of neighbouring frames among some frames: the hull of their parameters,
// with the elements of the first. It ignores other values between the two frames, and frames at
// which values have left their range.
std::vector<formula::Region> regions(const scene::OneSurface& one, const scene::SurfaceAt& first);

} // namespace isomotion::probe
