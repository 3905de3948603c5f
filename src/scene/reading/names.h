// Names that scenes give to parameters, arrays and fields.
#pragma once

#include <string>

#include "scene/reading/document.h"

namespace isomotion::scene {

// Throws SceneError unless formulas and expressions can say the name and mean nothing else by it.
void check_name(const std::string& name, const toml::node& at, const std::string& key);

} // namespace isomotion::scene
