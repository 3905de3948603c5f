// Replaces a scene's own camera by one that a person moved.
#pragma once

#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// The scene as if its file had this camera (camera_text.h); a light over the viewer's shoulder
// follows it. The camera's tracks come after the scene's.
scene::Scene with_camera(scene::Scene scene, const scene::CameraAt& camera);

} // namespace isomotion::player
