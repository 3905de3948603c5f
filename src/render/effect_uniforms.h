// The plain uniforms of the effects that a scene calls for, by name; shaders/effects/ says what
// they are. A program without one of them ignores it.
#pragma once

#include "render/uniform.h"
#include "scene/scene_at.h"

namespace isomotion::render {

Uniforms effect_uniforms(const scene::Scene& scene, const scene::SceneAt& now);

} // namespace isomotion::render
