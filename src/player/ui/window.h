// The window: GLFW's events and Dear ImGui's frames in it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <isomotion/error.h>

#include "gpu/glfw_context.h"
#include "gpu/screen.h"
#include "player/model/memory.h"

struct GLFWwindow;
struct ImGuiContext;

namespace isomotion::player {

// A key that was pressed or repeats: GLFW's code, or 0 and the character if text was typed.
struct KeyPress {
    int key = 0;
    int mods = 0; // GLFW_MOD_*
    char32_t character = 0;
    bool repeats = false;
};

// A picture and its place, in pixels from the window's upper left corner.
struct PlacedPicture {
    const gpu::ScreenTexture* texture = nullptr;
    glm::ivec2 corner{0}, size{1};
};

// There is no display, or no OpenGL on it.
class NoWindow : public Error {
public:
    explicit NoWindow(const std::string& message)
        : Error(Code::device, message) {}
};

// The main thread has at most one. Its context is current there during its lifetime.
class Window {
public:
    // Opens at the remembered place, moved onto a screen; otherwise where the desktop puts it.
    // Throws NoWindow.
    Window(const std::string& title, const std::optional<WindowPlace>& remembered);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Sleeps until an event comes, or for so many seconds (without limit if below 0).
    void wait(double seconds);
    // Wakes wait(). May be called from any thread.
    static void wake();

    void make_current();

    // Make Dear ImGui's widgets between the two. Returns false if there is nothing to draw into
    // (minimised, or of zero size): don't call end_frame() then.
    bool begin_frame();
    // Draws the widgets over a picture. Throws gpu::ContextLost.
    void end_frame(const std::optional<PlacedPicture>& picture);
    // Replaces end_frame(): the widgets have processed their events, and nothing is drawn. On a
    // software renderer this saves as much time as a small picture takes. Another frame must
    // follow.
    void skip_frame();
    // Replaces end_frame(): everything in the window stays except the picture, which replaces the
    // previous one. The widgets have processed their events, as with skip_frame(). Returns false
    // without effect if widgets cover the picture, if the picture or the window has another place
    // or size than in the last frame, or if the driver does not keep the pixels that were shown.
    // Software renderers keep them, and only there it saves time.
    bool replace(const PlacedPicture& picture);

    // Whether events are still to be shown by further frames. Dear ImGui takes some frames to
    // settle.
    bool stale() const { return stale_frames_ > 0; }
    void refresh(); // requests frames without an event

    bool closing() const;
    void close();
    void set_title(const std::string& title);
    void toggle_full_screen();
    WindowPlace place() const;
    void copy(const std::string& text); // to the clipboard

    glm::ivec2 pixels() const; // of the framebuffer
    bool hidden() const;       // there is nothing to draw into: minimised, or of zero size

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
    std::optional<bool> keeps_;           // whether pixels can be drawn over after they were shown
    int stale_frames_ = 0;
    bool full_screen_ = false;
    WindowPlace windowed_; // the place to which full screen returns
    std::vector<KeyPress> keys_;
    std::vector<std::filesystem::path> dropped_;
    // Dear ImGui reads the state of keys once per frame. A key that is pressed and released between
    // two frames is released in the next.
    std::vector<int> pressed_, released_;
};

} // namespace isomotion::player
