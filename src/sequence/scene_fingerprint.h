// Tells one scene from another, whatever frame is asked for.
#pragma once

#include <string>

#include "scene/scene.h"

namespace isomotion::sequence {

// Fingerprint of what the scene file and the command line say: the formula, how everything moves,
// the method and its settings, the effects. Comments, order and the number of frames do not count,
// nor does how a map or a table of elements changed under its name: that shows in the frames' own
// fingerprints.
std::string scene_fingerprint(const scene::Scene& scene);

} // namespace isomotion::sequence
