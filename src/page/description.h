// The description of a page's scene, without the values of frames, as JSON that src/page/web/
// reads.
#pragma once

#include <string>

#include "page/environment_map.h"
#include "page/frame_values.h"
#include "page/page.h"
#include "page/web_scene.h"

namespace isomotion::page {

// The formula, or those of all surfaces with their names, a line each.
std::string formulas_of(const WebScene& web);

// `environment` is null if the scene has none. Throws InputError for a report that is broken or of
// another scene. For such a timeline beside the scene it calls the options' `warn`.
std::string description(const WebScene& web, const FrameValues& values,
                        const Environment* environment, const PageOptions& options);

} // namespace isomotion::page
