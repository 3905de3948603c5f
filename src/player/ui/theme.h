// The appearance of the window: one dark grey, one accent, one font.
#pragma once

#include <glm/vec3.hpp>

namespace isomotion::player {

// Sets fonts and style of Dear ImGui's current context, for a screen of this scale.
void apply_theme(float scale);

glm::vec3 background_color(); // sRGB codes, 0 to 1

// Packed in the format of Dear ImGui's draw lists.
unsigned accent_color();
unsigned text_color();
unsigned faint_color(); // lines, and less important text
unsigned error_color();

} // namespace isomotion::player
