// Converts the changes that a person made to a scene to settings of `isomotion render`.
#pragma once

#include <vector>

#include "player/model/session.h"
#include "scene/reading/load.h"

namespace isomotion::player {

// Settings that load the session's scene as it is shown: camera, parameters, method. With the shown
// size and samples, frames rendered with them equal the pictures shown at rest, bit for bit. Throws
// std::runtime_error if no setting can express a change: a field from a file, multiplied.
std::vector<scene::Override> render_settings(const Session& session);

} // namespace isomotion::player
