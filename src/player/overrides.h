// What a person changed of a scene, as `isomotion render` takes it.
#pragma once

#include <vector>

#include "player/session.h"
#include "scene/reading/load.h"

namespace isomotion::player {

// Settings that load the session's scene as it is shown: its camera, its parameters, its method.
// With the size and the samples that are shown, its frames are the pictures shown at rest, bit for
// bit. Throws
// std::runtime_error where that cannot be said: an element's field from a file, multiplied.
std::vector<scene::Override> overrides_of(const Session& session);

} // namespace isomotion::player
