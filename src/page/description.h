// What a page knows of its scene beside the values of frames, as JSON: src/page/web/ reads it.
#pragma once

#include <string>

#include "page/environment_map.h"
#include "page/frame_values.h"
#include "page/page.h"
#include "page/web_scene.h"

namespace isomotion::page {

// `environment` is null where the scene has none. Throws InputError for a report that is broken or
// of another scene; of a timeline beside the scene that is so, the options' `warn` is told.
std::string description(const WebScene& web, const FrameValues& values,
                        const Environment* environment, const PageOptions& options);

} // namespace isomotion::page
