// Identifies a scene, whichever frame is requested.
#pragma once

#include <string>

#include "scene/scene.h"

namespace isomotion::sequence {

// Fingerprint of what the scene file and the command line state: the formula, all motion, the
// method and its settings, the effects. It ignores comments, order and the number of frames. It
// also ignores changes of content in an environment's map, which change the frames' own
// fingerprints. It includes what is read of tables of elements.
std::string scene_fingerprint(const scene::Scene& scene);

} // namespace isomotion::sequence
