// Scene file (TOML) -> Scene.
#pragma once

#include <string>
#include <vector>

#include "scene/error.h"
#include "scene/scene.h"

namespace isomotion::scene {

// "name=value" of the command line: `name` is a parameter, or a dotted key of the scene file
// ("camera.fov"); `value` a number or an expression.
using Override = std::string;

// `scene` is a path to a .toml file or the name of an animation of the gallery. Throws SceneError.
Scene load(const std::string& scene, const std::vector<Override>& overrides = {});

} // namespace isomotion::scene
