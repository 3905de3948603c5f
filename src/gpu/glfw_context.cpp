#include "gpu/glfw_context.h"

#include "gpu/backends.h"
#include "gpu/lost_display.h"

// Its own GL headers would declare what the loader defines.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace isomotion::gpu {
namespace {

/// Over a window that it may own.
class GlfwContext final : public Context {
public:
    explicit GlfwContext(GLFWwindow* window)
        : Context("glfw", glfwGetProcAddress)
        , window_(window) {}

    GlfwContext(std::shared_ptr<Glfw> glfw, GLFWwindow* window)
        : Context("glfw", glfwGetProcAddress)
        , glfw_(std::move(glfw))
        , window_(window) {}

    ~GlfwContext() override {
        release();
        if (glfw_) glfwDestroyWindow(window_);
    }

private:
    void bind() override {
        glfwMakeContextCurrent(window_);
        if (glfwGetCurrentContext() == window_) return;
        throw std::runtime_error("glfwMakeContextCurrent failed: " + Glfw::reason());
    }

    void unbind() noexcept override { glfwMakeContextCurrent(nullptr); }

    std::shared_ptr<Glfw> glfw_; // of a window of its own
    GLFWwindow* window_;
};

} // namespace

std::shared_ptr<Glfw> Glfw::open() {
    static std::weak_ptr<Glfw> opened;
    if (auto held = opened.lock()) return held;
    if (!glfwInit()) throw std::runtime_error(reason());
    watch_display();
    std::shared_ptr<Glfw> glfw(new Glfw);
    opened = glfw;
    return glfw;
}

Glfw::~Glfw() {
    glfwTerminate(); // and with it the driver goes
    forget_functions();
}

void Glfw::hint(std::pair<int, int> version, bool visible) const {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version.first);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version.second);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // Where the driver can, it tells of a reset instead of ending the process.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
}

std::string Glfw::reason() {
    const char* text = nullptr;
    const int code = glfwGetError(&text);
    if (code == GLFW_NO_ERROR) return "GLFW gives no reason";
    return text ? text : fmt::format("GLFW error {}", code);
}

std::unique_ptr<Context> context_of(GLFWwindow* window) {
    auto context = std::make_unique<GlfwContext>(window);
    context->make_current();
    context->describe();
    return context;
}

std::unique_ptr<Context> open_glfw(std::vector<Attempt>& failed) {
    try {
        const auto glfw = Glfw::open();
        for (const auto& version : wanted_versions) {
            glfw->hint(version, false);
            GLFWwindow* window = glfwCreateWindow(16, 16, "isomotion", nullptr, nullptr);
            if (window) return std::make_unique<GlfwContext>(glfw, window);
        }
        throw std::runtime_error(Glfw::reason());
    } catch (const std::runtime_error& error) {
        failed.push_back({"glfw", error.what()});
        return nullptr;
    }
}

} // namespace isomotion::gpu
