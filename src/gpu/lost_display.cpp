#include "gpu/lost_display.h"

#include <dlfcn.h>

namespace isomotion::gpu {
namespace {

void (*end_process)() = nullptr;

// Xlib calls this as int handler(Display*).
int on_io_error(void*) {
    end_process();
    return 0;
}

} // namespace

void end_when_display_is_lost(void (*end)()) { end_process = end; }

void watch_display() {
    // Not linked: on Wayland, or without a display, it isn't there.
    void* const xlib = end_process ? ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD) : nullptr;
    if (!xlib) return;
    using Handler = int (*)(void*);
    using SetHandler = Handler (*)(Handler);
    if (const auto set = reinterpret_cast<SetHandler>(::dlsym(xlib, "XSetIOErrorHandler"))) {
        set(on_io_error);
    }
    ::dlclose(xlib);
}

} // namespace isomotion::gpu
