// Names that scenes give to parameters, arrays and fields.
#pragma once

#include <string>
#include <string_view>

#include "scene/reading/document.h"

namespace isomotion::scene {

// Throws SceneError for a name that formulas and expressions cannot use, or that means something
// else there.
void check_name(const std::string& name, const toml::node& at, const std::string& key);

// The same for a parameter: i and n are special in scenes with arrays alone.
void check_parameter_name(const std::string& name, const toml::node& at, const std::string& key,
                          bool has_arrays);

} // namespace isomotion::scene
