// A camera that a person moved, in place of the scene's own.
#pragma once

#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// The scene as if its file had this camera (camera_text.h): a light over the viewer's shoulder
// follows it. Its tracks come after the scene's.
scene::Scene with_camera(scene::Scene scene, const scene::CameraAt& camera);

} // namespace isomotion::player
