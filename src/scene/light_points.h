// Lights with a size are sampled one point per picture. The mean over the pictures of a frame has
// soft shadows.
#pragma once

#include "scene/scene_at.h"

namespace isomotion::scene {

// Whether some light has a radius. Otherwise every point of a light gives the same light.
bool is_lit_by_discs(const SceneAt& now);

// The scene lit from another point of every light that has a radius. `disc` is in the unit disc;
// its middle leaves the scene unchanged.
SceneAt lit_from(SceneAt now, const glm::dvec2& disc);

} // namespace isomotion::scene
