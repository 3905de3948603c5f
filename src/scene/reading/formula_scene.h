// Makes a scene of a formula alone.
#pragma once

#include <span>
#include <string>

#include <toml++/toml.h>

namespace isomotion::scene {

// Whether the argument that names a scene looks like a formula rather than a file or an animation.
bool is_formula(const std::string& name);

// The document of a formula's scene. If the formula or a setting (load.h) names t, the scene moves
// for 120 frames.
toml::table scene_of_formula(const std::string& formula, std::span<const std::string> settings);

} // namespace isomotion::scene
