// Looks: named sets of light, shading and background for scenes.
#pragma once

#include <toml++/toml.h>

#include "scene/reading/document.h"
#include "scene/scene.h"

namespace isomotion::scene {

// Puts into `look` the settings of the look that a scene names, and returns its name and those of
// its keys that the scene doesn't have itself. The look's file is read below the document: sections
// key by key, lights as a whole. Keys that belong together are left out where the document has one:
// a model with its values, a background or an environment. Throws PlacedError if there is no such
// look.
NamedLook look_below(Section& document, const toml::node* named, toml::table& look);

// Adds the settings to the document where it has none itself.
void put_under(toml::table& document, toml::table look);

} // namespace isomotion::scene
