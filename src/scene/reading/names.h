// Names that scenes give to parameters, arrays and fields.
#pragma once

#include <string>

#include "scene/reading/document.h"

namespace isomotion::scene {

// Throws SceneError for a name that formulas and expressions cannot use, or that means something
// else there.
void check_name(const std::string& name, const toml::node& at, const std::string& key);

} // namespace isomotion::scene
