// A camera as the [camera] of a scene file.
#pragma once

#include <string>

#include "scene/scene_at.h"

namespace isomotion::player {

// TOML with its heading, a line each key. Loaded in any scene it is the same camera to the last
// bit, in all that its projection uses: position, target, up, fov or height, zoom and, with an
// aperture, the lens. Numbers are the shortest decimals that read back as the same doubles. What is
// the default (up, zoom) is left out. `shutter` is scene::Camera's, which no moment has.
std::string camera_text(const scene::CameraAt& camera, double shutter = 0);

} // namespace isomotion::player
