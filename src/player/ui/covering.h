// Tells whether something in Dear ImGui's frame covers the picture.
#pragma once

#include <imgui.h>

namespace isomotion::player {

// Whether anything drawn in the frame does, by the bounding boxes of its triangles.
bool is_covered(const ImDrawData& frame, ImVec2 low, ImVec2 high);

} // namespace isomotion::player
