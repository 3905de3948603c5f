#include "player/ui/window.h"

#include <algorithm>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "player/ui/covering.h"
#include "player/ui/theme.h"

namespace isomotion::player {
namespace {

// A frame after an event may open a widget, the next lays it out, the one after it shows it.
constexpr int frames_to_settle = 3;
constexpr int smallest_width = 480, smallest_height = 320;
constexpr int usual_width = 1280, usual_height = 800;

std::vector<WorkArea> work_areas() {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::vector<WorkArea> areas;
    for (int k = 0; k < count; ++k) {
        WorkArea area;
        glfwGetMonitorWorkarea(monitors[k], &area.x, &area.y, &area.width, &area.height);
        if (area.width > 0 && area.height > 0) areas.push_back(area);
    }
    return areas;
}

// Screens come and go; a place that was remembered may be on none.
std::optional<WindowPlace> on_screen(const std::optional<WindowPlace>& place) {
    if (!place) return std::nullopt;
    return within(*place, work_areas());
}

// A size that was remembered is already the screen's; the usual one is not.
GLFWwindow* open_window(const gpu::Glfw& glfw, const std::string& title,
                        const std::optional<WindowPlace>& place) {
    const int width = place ? place->width : usual_width;
    const int height = place ? place->height : usual_height;
    for (const auto& version : {std::pair{4, 5}, std::pair{3, 3}}) {
        glfw.hint(version, true);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, place ? GLFW_FALSE : GLFW_TRUE);
        glfwWindowHint(GLFW_MAXIMIZED, place && place->maximised ? GLFW_TRUE : GLFW_FALSE);
        if (GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr)) {
            return window;
        }
    }
    throw NoWindow("no window can be opened: " + gpu::Glfw::reason());
}

std::shared_ptr<gpu::Glfw> open_display() {
    try {
        return gpu::Glfw::open();
    } catch (const std::runtime_error& error) {
        throw NoWindow(std::string("no display: ") + error.what());
    }
}

} // namespace

struct Window::Events {
    static Window& of(GLFWwindow* window) {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }

    static void key(GLFWwindow* window, int key, int scancode, int action, int mods) {
        Window& self = of(window);
        self.refresh();
        if (action == GLFW_RELEASE &&
            std::ranges::find(self.pressed_, key) != self.pressed_.end()) {
            self.released_.push_back(key);
            return;
        }
        if (action == GLFW_PRESS) self.pressed_.push_back(key);
        ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, mods);
        if (action != GLFW_RELEASE) self.keys_.push_back({key, mods, 0, action == GLFW_REPEAT});
    }

    static void character(GLFWwindow* window, unsigned code) {
        Window& self = of(window);
        self.refresh();
        ImGui_ImplGlfw_CharCallback(window, code);
        self.keys_.push_back({0, 0, char32_t(code), false});
    }

    static void install(GLFWwindow* window) {
        glfwSetKeyCallback(window, key);
        glfwSetCharCallback(window, character);
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
            of(w).refresh();
            ImGui_ImplGlfw_MouseButtonCallback(w, button, action, mods);
        });
        glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
            of(w).refresh();
            ImGui_ImplGlfw_ScrollCallback(w, x, y);
        });
        glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { of(w).refresh(); });
        glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
            of(w).refresh();
            ImGui_ImplGlfw_CursorEnterCallback(w, entered);
        });
        glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
            of(w).refresh();
            ImGui_ImplGlfw_WindowFocusCallback(w, focused);
        });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).refresh(); });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).refresh(); });
        glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { of(w).refresh(); });
        glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) {
            of(w).rescale();
            of(w).refresh();
        });
        glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
            of(w).refresh();
            of(w).dropped_.insert(of(w).dropped_.end(), paths, paths + count);
        });
    }
};

Window::Window(const std::string& title, const std::optional<WindowPlace>& remembered)
    : glfw_(open_display())
    , windowed_(remembered.value_or(WindowPlace{0, 0, usual_width, usual_height})) {
    const std::optional<WindowPlace> place = on_screen(remembered);
    if (place) windowed_ = *place;
    window_ = open_window(*glfw_, title, place);
    if (place && !place->maximised) glfwSetWindowPos(window_, place->x, place->y);
    glfwSetWindowSizeLimits(window_, smallest_width, smallest_height, GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, this);
    try {
        context_ = gpu::context_of(window_);
    } catch (const std::runtime_error& error) {
        glfwDestroyWindow(window_);
        throw NoWindow(std::string("no OpenGL in a window here: ") + error.what());
    }
    glfwSwapInterval(1);
    IMGUI_CHECKVERSION();
    widgets_ = ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // what is remembered, the player itself remembers
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    Events::install(window_);
    rescale();
    refresh();
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext(widgets_);
    context_.reset();
    glfwDestroyWindow(window_);
}

void Window::rescale() {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    apply_theme(std::clamp(std::max(x, y), 0.5f, 4.0f)); // 1 on an ordinary screen
    ImGui_ImplOpenGL3_DestroyDeviceObjects(); // the next frame makes them anew, with the new font
}

void Window::wait(double seconds) {
    if (stale()) {
        glfwPollEvents();
    } else if (seconds < 0) {
        glfwWaitEvents();
    } else if (seconds > 0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::wake() { glfwPostEmptyEvent(); }

void Window::make_current() { context_->make_current(); }

bool Window::begin_frame() {
    stale_frames_ = std::max(0, stale_frames_ - 1);
    if (hidden()) {
        stale_frames_ = 0;
        return false;
    }
    context_->make_current();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    pressed_.clear();
    return true;
}

void Window::skip_frame() {
    ImGui::EndFrame();
    stale_frames_ = 0;
}

void Window::end_frame(const std::optional<PlacedPicture>& picture) {
    ImGui::Render();
    drawn_ = pixels();
    gpu::begin_screen(drawn_.x, drawn_.y, background_color());
    placed_ = picture;
    if (picture) place(*picture);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    present();
    for (const int key : std::exchange(released_, {})) {
        ImGui_ImplGlfw_KeyCallback(window_, key, 0, GLFW_RELEASE, 0);
        refresh();
    }
}

bool Window::replace(const PlacedPicture& picture) {
    const bool has_its_place =
        placed_ && placed_->corner == picture.corner && placed_->size == picture.size;
    if (!keeps_.value_or(false) || drawn_ != pixels() || !has_its_place) return false;
    ImGui::Render();
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale; // pixels a unit of Dear ImGui's
    const glm::vec2 low(picture.corner), high(picture.corner + picture.size);
    if (is_covered(*ImGui::GetDrawData(), {low.x / pixel.x, low.y / pixel.y},
                   {high.x / pixel.x, high.y / pixel.y}))
        return false;
    place(picture);
    present();
    stale_frames_ = 0;
    return true;
}

void Window::place(const PlacedPicture& picture) const {
    const auto [corner, size] = std::pair(picture.corner, picture.size);
    gpu::place(*picture.texture, {corner.x, drawn_.y - corner.y - size.y, size.x, size.y});
}

void Window::present() {
    // Nothing says what a buffer holds after it was shown, but Mesa's software renderers copy it to
    // the window and leave it. A new buffer would be black.
    const bool is_known = keeps_.has_value();
    const auto drawn = is_known ? decltype(gpu::drawn_pixel(0, 0)){} : gpu::drawn_pixel(0, 0);
    glfwSwapBuffers(window_);
    context_->expect_alive();
    if (is_known) return;
    const bool is_black = std::ranges::count(drawn, 0) == 3;
    keeps_ = context_->info().software && !is_black && gpu::drawn_pixel(0, 0) == drawn;
}

void Window::refresh() { stale_frames_ = frames_to_settle; }

bool Window::closing() const { return glfwWindowShouldClose(window_); }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::toggle_full_screen() {
    if (full_screen_) {
        glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width,
                             windowed_.height, GLFW_DONT_CARE);
        full_screen_ = false;
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    windowed_ = place();
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    full_screen_ = true;
}

WindowPlace Window::place() const {
    if (full_screen_) return windowed_;
    WindowPlace now;
    glfwGetWindowPos(window_, &now.x, &now.y);
    glfwGetWindowSize(window_, &now.width, &now.height);
    now.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
    return now;
}

void Window::copy(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

glm::ivec2 Window::pixels() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

bool Window::hidden() const {
    const glm::ivec2 size = pixels();
    return size.x < 1 || size.y < 1 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

std::vector<KeyPress> Window::take_keys() { return std::exchange(keys_, {}); }

std::vector<std::filesystem::path> Window::take_dropped() { return std::exchange(dropped_, {}); }

} // namespace isomotion::player
