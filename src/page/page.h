// A scene as one HTML file that plays it: no network, no framework, every shader that `render` has.
//
// The file holds the passes' text in GLSL ES 3.00, the values of every frame as render uploads
// them, and the scripts of web/, which draw with WebGL2.
#pragma once

#include <string>

#include "scene/scene.h"

namespace isomotion::page {

// Throws SceneError for what a page cannot show or hold (web_scene.h), and what reading an
// environment map throws.
std::string page(const scene::Scene& scene);

} // namespace isomotion::page
