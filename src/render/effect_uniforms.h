// The plain uniforms of the effects that a scene calls for, by name; shaders/effects/ says what
// they are. A program without one of them ignores it.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene_at.h"

namespace isomotion::render {

using EffectUniform = std::variant<float, glm::vec2, glm::vec3, glm::vec4>;
using EffectUniforms = std::vector<std::pair<std::string, EffectUniform>>;

EffectUniforms effect_uniforms(const scene::Scene& scene, const scene::SceneAt& now);

} // namespace isomotion::render
