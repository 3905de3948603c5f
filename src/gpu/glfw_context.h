#pragma once

#include "gpu/context.h"

#include <memory>

struct GLFWwindow;

namespace isomotion::gpu {

/// GLFW, set up for as long as somebody holds it. Of the main thread only, as are windows: only
/// making a context current and waking the one that waits for events may be done elsewhere.
class Glfw {
public:
    /// Throws std::runtime_error with GLFW's reason, such as that there is no display.
    static std::shared_ptr<Glfw> open();
    ~Glfw();
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;

    /// Asks that the next window have a core profile of this version, and whether it is seen.
    void hint(std::pair<int, int> version, bool visible) const;

    /// Why the last call failed.
    static std::string reason();

private:
    Glfw() = default;
};

/// The context of a window, which must outlive it. It is made current on the calling thread and may
/// be made so on another once it is released here. Throws std::runtime_error.
std::unique_ptr<Context> context_of(GLFWwindow* window);

} // namespace isomotion::gpu
