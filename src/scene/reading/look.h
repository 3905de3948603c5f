// Looks: named sets of light, shading and background for scenes.
#pragma once

#include <toml++/toml.h>

#include "scene/scene.h"

namespace isomotion::scene {

// Adds to a scene's document the settings of the look that it names where the scene doesn't have
// its own, and returns which. A section is filled in key by key. Lights are replaced as a whole,
// and so are keys that belong together: a model with its values, a background or an environment.
// Without a look the document is unchanged. Throws SceneError if there is no such look.
NamedLook put_look(toml::table& document);

} // namespace isomotion::scene
