// Chooses how shaders find the elements that matter where they evaluate F: in lists that beams of
// rays make, by place in a grid, or by going through all.
#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "synthesis/field_text.h"

namespace isomotion::synthesis {

struct Drawing;

// `keeps_copies`: where shaders can write no lists, these may be copies.
FieldStorage storage_of_elements(const scene::Scene& scene, const Drawing& drawing,
                                 bool keeps_copies);

// Pictures of fewer pixels are drawn faster by other shaders, since beams are wider in them and
// lists longer. The most of the scene's surfaces; 0 if the number of pixels decides nothing.
std::int64_t fewest_pixels_for_lists(const scene::Scene& scene);

} // namespace isomotion::synthesis
