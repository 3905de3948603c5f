// Whether something in Dear ImGui's frame lies over the picture.
#pragma once

#include <imgui.h>

namespace isomotion::player {

// Whether anything does that the frame draws, by the boxes of its triangles.
bool is_covered(const ImDrawData& frame, ImVec2 low, ImVec2 high);

} // namespace isomotion::player
