// Draws rings over the picture, in the colours of their kinds and with their words.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "player/model/event_rings.h"

namespace isomotion::player {

// Draws in Dear ImGui's current window, over the picture at this corner and of this size, in
// pixels. Words are left out where they would cover other rings or words.
void draw_rings(const std::vector<Ring>& rings, const std::vector<PlacedEvent>& events,
                glm::ivec2 corner, glm::ivec2 size);

} // namespace isomotion::player
