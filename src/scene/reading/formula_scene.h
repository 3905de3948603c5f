// Makes a scene of a formula alone.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace isomotion::scene {

// Whether the argument that names a scene looks like a formula rather than a file or an animation.
bool is_formula(const std::string& name);

// The document of a formula's scene. If the formula names t, the scene moves for 120 frames; t is a
// parameter in it, since formulas know the time only by parameters.
toml::table scene_of_formula(const std::string& formula);

} // namespace isomotion::scene
