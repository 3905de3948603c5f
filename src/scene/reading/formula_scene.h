// A formula alone as a scene.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace isomotion::scene {

// Whether what names a scene looks like a formula, and not like a file or an animation.
bool is_formula(const std::string& name);

// The document of the scene that a formula is. Where it names t it moves, for 120 frames: formulas
// know the time by a parameter.
toml::table scene_of_formula(const std::string& formula);

} // namespace isomotion::scene
