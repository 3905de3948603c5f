#pragma once

namespace isomotion::gpu {

/// Sets the function that ends the process when the X server of its windows goes away; it must not
/// return. Xlib's own function exits with 1 and its own message. Call this before the display is
/// opened; Glfw::open() registers it with Xlib.
void end_when_display_is_lost(void (*end)());

/// Registers it with Xlib, if GLFW has loaded Xlib.
void watch_display();

} // namespace isomotion::gpu
