// Where a scene looks at its formula: the box around its bounds, and what its names stand for, over
// all of its frames.
#pragma once

#include <vector>

#include "formula/smoothness.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

// One for each two neighbours of some frames: the hull of their parameters, and the elements of the
// first. What else happens between them is left out, and so are frames at which values have left
// their range.
std::vector<formula::Region> regions(const Scene& scene, const SceneAt& first);

} // namespace isomotion::scene
