// Draws the icons of the transport's buttons, so that they don't depend on a font.
#pragma once

namespace isomotion::player {

enum class Icon { play, pause, first, last, back, forward, loop };

// A square button as high as a line of widgets; returns true when it is clicked. `lit`: the icon
// has the accent colour. `tip` is shown while the mouse hovers over it.
bool icon_button(const char* id, Icon icon, bool lit, const char* tip);

} // namespace isomotion::player
