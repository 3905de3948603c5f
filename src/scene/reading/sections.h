// Reads [[sections]]: the parts that are cut off the solid.
#pragma once

#include <vector>

#include "scene/reading/track_table.h"

namespace isomotion::scene {

std::vector<Cut> read_sections(Section& document, TrackTable& tracks);

} // namespace isomotion::scene
