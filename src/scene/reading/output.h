// Reads [output].
#pragma once

#include "scene/reading/document.h"
#include "scene/scene.h"

namespace isomotion::scene {

// Reads it after camera and lights, which tell how many samples are drawn where none are given.
void read_output(Section& document, Scene& scene);

} // namespace isomotion::scene
