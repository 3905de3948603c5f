// --set: a value is put into the document before it is read, so that it is checked like any other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/reading/document.h"

namespace isomotion::scene {

// `setting`: "m=2.5", "camera.fov=30", "surfaces.ring.transform.scale=2". Throws SceneError.
void override_key(toml::table& document, const std::string& setting);

// A message about one surface of a list, of this name and index, with the key as it was set:
// "--set: surfaces.ring.material.colour: unknown key". Others are as they were.
std::string as_set(std::string message, const std::vector<std::string>& settings,
                   const std::string& name, std::size_t index);

} // namespace isomotion::scene
