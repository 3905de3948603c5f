// What a file says about the frame in it. Nothing here changes from run to run.
#pragma once

#include <string>

#include "image/frame.h"
#include "render/renderer.h"
#include "scene/scene_at.h"

namespace isomotion::app {

// The name under which a file keeps the fingerprint of what it was rendered from.
inline constexpr const char* fingerprint_key = "isomotion:fingerprint";

image::Metadata frame_metadata(const scene::Scene& scene, const scene::SceneAt& now,
                               const animation::Values& values, int frame,
                               const std::string& fingerprint);

} // namespace isomotion::app
