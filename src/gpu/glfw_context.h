#pragma once

#include "gpu/context.h"

#include <memory>

struct GLFWwindow;

namespace isomotion::gpu {

/// GLFW, initialised as long as somebody holds it. Use it and windows only from the main thread.
/// Other threads may only make a context current and wake the thread that waits for events.
class Glfw {
public:
    /// Throws std::runtime_error with GLFW's reason, such as that there is no display.
    static std::shared_ptr<Glfw> open();
    ~Glfw();
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;

    /// Requests that the next window have a core profile of this version, and sets whether it is
    /// visible.
    void hint(std::pair<int, int> version, bool visible) const;

    /// The reason why the last call failed.
    static std::string reason();

private:
    Glfw() = default;
};

/// The context of a window, which must outlive it. It is current on the calling thread, and may
/// become current on another thread after release() here. Throws std::runtime_error.
std::unique_ptr<Context> context_of(GLFWwindow* window);

} // namespace isomotion::gpu
