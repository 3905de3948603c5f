// What a page knows of its scene beside the values of frames, as JSON: src/page/web/ reads it.
#pragma once

#include <string>

#include "page/environment_map.h"
#include "page/frame_values.h"
#include "page/web_scene.h"

namespace isomotion::page {

// `environment` is null where the scene has none.
std::string description(const WebScene& web, const FrameValues& values,
                        const EnvironmentMap* environment);

} // namespace isomotion::page
