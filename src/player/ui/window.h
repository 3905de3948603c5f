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
#include "gpu/screen.h"
#include "player/model/memory.h"

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

// A picture and where it lies, pixels from the window's upper left corner.
struct PlacedPicture {
    const gpu::ScreenTexture* texture = nullptr;
    glm::ivec2 corner{0}, size{1};
};

// No display, or no OpenGL on it.
class NoWindow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The main thread has one at a time. Its context is current there as long as it lives.
class Window {
public:
    // Opens at the remembered place, moved onto a screen; else where the desktop puts it.
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

    // Make Dear ImGui's widgets between the two. False if there is nothing to draw into (minimised,
    // or of no size): don't call end_frame() then.
    bool begin_frame();
    // Draws the widgets, over a picture. Throws gpu::ContextLost.
    void end_frame(const std::optional<PlacedPicture>& picture);
    // In place of end_frame(): the widgets have taken their events, and nothing is drawn, which
    // would take a software renderer as long as a small picture. Another frame has to follow.
    void skip_frame();
    // In place of end_frame(): all that the window shows stays, but for a picture in place of the
    // one before. The widgets have taken their events, as by skip_frame(). False, and nothing is
    // done, where widgets lie over the picture, where it or the window has another place or size
    // than in the frame before, or where the driver keeps no pixels that were shown. Software
    // renderers do, and only there it saves time.
    bool replace(const PlacedPicture& picture);

    // Whether frames have yet to show events that came. Dear ImGui takes some frames to settle.
    bool stale() const { return stale_frames_ > 0; }
    void refresh(); // asks for frames though no event came

    bool closing() const;
    void close();
    void set_title(const std::string& title);
    void toggle_full_screen();
    WindowPlace place() const;
    void copy(const std::string& text); // to the clipboard

    glm::ivec2 pixels() const; // of the framebuffer
    bool hidden() const;       // there is nothing to draw into: minimised, or of no size

    // Keys and dropped files since the last call.
    std::vector<KeyPress> take_keys();
    std::vector<std::filesystem::path> take_dropped();

private:
    struct Events; // GLFW's callbacks
    void rescale();
    void place(const PlacedPicture& picture) const;
    void present();

    std::shared_ptr<gpu::Glfw> glfw_;
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<gpu::Context> context_;
    ImGuiContext* widgets_ = nullptr;
    glm::ivec2 drawn_{0};                 // the pixels of the last frame
    std::optional<PlacedPicture> placed_; // its picture
    std::optional<bool> keeps_;           // whether they can be drawn over after they were shown
    int stale_frames_ = 0;
    bool full_screen_ = false;
    WindowPlace windowed_; // the place that full screen goes back to
    std::vector<KeyPress> keys_;
    std::vector<std::filesystem::path> dropped_;
    // Dear ImGui reads the state of keys once a frame: a key that goes down and up between two
    // frames is released in the next.
    std::vector<int> pressed_, released_;
};

} // namespace isomotion::player
