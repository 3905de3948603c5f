// --set: a value is put into the document before it is read, so that it is checked like any other.
#pragma once

#include <string>
#include <vector>

#include "scene/reading/document.h"

namespace isomotion::scene {

// `setting`: "m=2.5", "camera.fov=30", "surfaces.ring.transform.scale=2". Throws SceneError.
void override_key(toml::table& document, const std::string& setting);

} // namespace isomotion::scene
