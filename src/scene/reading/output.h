// Reads [output].
#pragma once

#include "scene/reading/document.h"
#include "scene/scene.h"

namespace isomotion::scene {

// Call it after reading camera and lights, which determine the default number of samples.
void read_output(Section& document, Scene& scene);

} // namespace isomotion::scene
