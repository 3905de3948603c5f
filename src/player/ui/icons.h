// Draws the transport's buttons, so that no font has to have them.
#pragma once

namespace isomotion::player {

enum class Icon { play, pause, first, last, back, forward, loop };

// A square button as high as a line of widgets; true when it is clicked. `lit`: the icon has the
// accent's colour. `tip` is shown where the mouse rests.
bool icon_button(const char* id, Icon icon, bool lit, const char* tip);

} // namespace isomotion::player
