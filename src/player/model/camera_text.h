// A camera as the [camera] of a scene file.
#pragma once

#include <string>

#include "scene/scene_at.h"

namespace isomotion::player {

// TOML with its heading, one line per key. Loaded in any scene it gives the same camera to the last
// bit, in everything that the projection uses: position, target, up, fov or height, zoom and, with
// an aperture, the lens. Numbers are the shortest decimals that read back as the same doubles.
// Defaults (up, zoom) are left out. `shutter` is that of scene::Camera, since CameraAt has none.
std::string camera_text(const scene::CameraAt& camera, double shutter = 0);

} // namespace isomotion::player
