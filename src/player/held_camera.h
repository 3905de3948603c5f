// A camera in the hand.
#pragma once

#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// The scene as if its file had this camera (camera_text.h) instead of its own: what follows from a
// camera, a light over the viewer's shoulder, follows this one. Its tracks come after the scene's.
scene::Scene with_camera(scene::Scene scene, const scene::CameraAt& camera);

} // namespace isomotion::player
