#pragma once

namespace isomotion::gpu {

/// What ends the process when the X server that windows are on goes away: it must not return. Xlib
/// itself ends it with 1 and words of its own. To be said before the display is opened;
/// Glfw::open() tells Xlib.
void end_when_display_is_lost(void (*end)());

/// Tells Xlib, where GLFW has loaded it.
void watch_display();

} // namespace isomotion::gpu
