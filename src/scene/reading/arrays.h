// The [arrays] of a scene.
#pragma once

#include <vector>

#include "base/confines.h"
#include "scene/reading/document.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

// The catalogue's arrays, where there is one, with the scene's over them field by field. A file of
// the scene's takes the place of the catalogue's lists. Remembers the place of every field.
std::vector<animation::Array> read_arrays(Section* catalogue, Section& document,
                                          const animation::Timeline& timeline, TrackTable& tracks,
                                          const base::Confines& within);

} // namespace isomotion::scene
