// The plain uniforms of the effects that a scene calls for, by name; shaders/effects/ says what
// they are. A program without one of them ignores it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene_at.h"

namespace isomotion::render {

using EffectUniforms = std::vector<std::pair<std::string, glm::vec4>>;

EffectUniforms effect_uniforms(const scene::Scene& scene, const scene::SceneAt& now);

} // namespace isomotion::render
