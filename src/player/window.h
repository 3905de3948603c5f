// The window: GLFW's events and Dear ImGui's frames in it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "gpu/glfw_context.h"
#include "player/memory.h"

struct GLFWwindow;
struct ImGuiContext;

namespace isomotion::player {

// A key that went down, or repeats: GLFW's code, or 0 and the character where text was typed.
struct KeyPress {
    int key = 0;
    int mods = 0; // GLFW_MOD_*
    char32_t character = 0;
    bool repeats = false;
};

// No display, or no OpenGL on it.
class NoWindow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// One at a time, of the main thread. Its context is current there as long as it lives.
class Window {
public:
    // At the place that is remembered, as far as a screen has it; else where the desktop puts it.
    // Throws NoWindow.
    Window(const std::string& title, const std::optional<WindowPlace>& remembered);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Sleeps until an event comes, or for so many seconds (below 0: for as long as it takes).
    void wait(double seconds);
    // Wakes wait(); from any thread.
    static void wake();

    void make_current();

    // Between the two, Dear ImGui's widgets are made. False if there is nothing to draw into
    // (minimised, or of no size); end_frame() must not be called then.
    bool begin_frame();
    void end_frame(); // throws gpu::ContextLost
    // In place of end_frame(): the widgets have taken what came, and nothing is drawn, which takes
    // a software renderer as long as a small picture. Another frame has to follow.
    void skip_frame();

    // Whether events came that frames have yet to show. Dear ImGui takes some frames to settle.
    bool stale() const { return stale_frames_ > 0; }
    void refresh(); // frames are wanted though no event came

    bool closing() const;
    void close();
    void set_title(const std::string& title);
    void toggle_full_screen();
    WindowPlace place() const;
    void copy(const std::string& text); // to the clipboard

    glm::ivec2 pixels() const; // of the framebuffer
    bool hidden() const;       // there is nothing to draw into: minimised, or of no size

    // What came since the last call.
    std::vector<KeyPress> take_keys();
    std::vector<std::filesystem::path> take_dropped();

private:
    struct Events; // GLFW's callbacks
    void rescale();

    std::shared_ptr<gpu::Glfw> glfw_;
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<gpu::Context> context_;
    ImGuiContext* widgets_ = nullptr;
    int stale_frames_ = 0;
    bool full_screen_ = false;
    WindowPlace windowed_; // the place that full screen goes back to
    std::vector<KeyPress> keys_;
    std::vector<std::filesystem::path> dropped_;
    // Dear ImGui reads which keys are down once a frame: one that goes down and up between two
    // frames goes up for it in the next.
    std::vector<int> pressed_, released_;
};

} // namespace isomotion::player
