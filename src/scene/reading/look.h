// Looks: light, shading and what is behind, together, for scenes to name.
#pragma once

#include <toml++/toml.h>

#include "scene/scene.h"

namespace isomotion::scene {

// Puts into a scene's document what the look that it names says and the scene doesn't, and tells
// what. A section is filled in key by key, but for lights, which are one's or the other's, and for
// what belongs together: a model with its values, a background or an environment. Without a look
// the document stays as it is. Throws SceneError for a look that there is not.
NamedLook put_look(toml::table& document);

} // namespace isomotion::scene
