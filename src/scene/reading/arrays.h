// Reads the [arrays] of a scene.
#pragma once

#include <vector>

#include "base/confines.h"
#include "scene/reading/document.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

// Reads the catalogue's arrays, if any, overridden field by field by the scene's. A file that the
// scene names replaces the catalogue's lists. Remembers the place of every field. Returns false
// where an array is wrong as a whole, so that not all names of formulas are known; what is wrong is
// told.
bool read_arrays(Section* catalogue, Section& sections, const animation::Timeline& timeline,
                 TrackTable& tracks, const base::Confines& within,
                 std::vector<animation::Array>& arrays);

} // namespace isomotion::scene
