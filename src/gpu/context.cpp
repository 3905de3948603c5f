#include "gpu/context.h"

#include "gpu/backends.h"
#include "gpu/error.h"
#include "gpu/name.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

namespace isomotion::gpu {
namespace {

constexpr std::array backend_names = {
    std::pair{Backend::automatic, std::string_view{"auto"}},
    std::pair{Backend::egl, std::string_view{"egl"}},
    std::pair{Backend::osmesa, std::string_view{"osmesa"}},
    std::pair{Backend::glfw, std::string_view{"glfw"}},
};

/// The default floating-point environment while a driver starts its threads: they inherit the
/// caller's, and one that rounds upward or traps would draw other pictures or end the process.
class DefaultArithmetic {
public:
    DefaultArithmetic() {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~DefaultArithmetic() { std::fesetenv(&saved_); }
    DefaultArithmetic(const DefaultArithmetic&) = delete;
    DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

private:
    std::fenv_t saved_;
};

std::string message(const std::vector<Attempt>& attempts) {
    std::string text = "no OpenGL context can be made here";
    for (const Attempt& attempt : attempts)
        text += fmt::format("\n  {}: {}", attempt.what, attempt.reason);
    return text + "\ninstall an OpenGL driver; on Debian: libegl1 libegl-mesa0 libgl1-mesa-dri, "
                  "or libosmesa6";
}

/// What found the functions that calls go to; all back ends' go to the same names.
GLADloadfunc loaded = nullptr;

std::string text_of(GLenum what) {
    const auto* text = reinterpret_cast<const char*>(glGetString(what));
    return text ? text : "";
}

int integer_of(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

// As many as Mesa's software renderer takes. Without any the caller's thread draws.
int drawing_threads() {
    constexpr int most = 32;
    int threads = int(std::thread::hardware_concurrency());
    if (const char* given = std::getenv("LP_NUM_THREADS"))
        std::from_chars(given, given + std::strlen(given), threads);
    return std::clamp(threads, 1, most);
}

bool draws_in_software(std::string_view renderer) {
    constexpr std::array names = {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software"};
    return std::ranges::any_of(
        names, [&](const char* name) { return renderer.find(name) != std::string_view::npos; });
}

} // namespace

Backend parse_backend(std::string_view text) {
    std::string known;
    for (const auto& [backend, name] : backend_names) {
        if (text == name) return backend;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", name);
    }
    throw std::invalid_argument(fmt::format("unknown back end '{}': it is one of {}", text, known));
}

std::string_view name(Backend backend) {
    return std::ranges::find(backend_names, backend, [](const auto& entry) { return entry.first; })
        ->second;
}

Unavailable::Unavailable(std::vector<Attempt> attempts)
    : Error(Code::device, message(attempts))
    , attempts_(std::move(attempts)) {}

thread_local Context* Context::current_ = nullptr;

std::unique_ptr<Context> Context::create(Backend backend) {
    const DefaultArithmetic arithmetic;
    std::vector<Attempt> failed;
    std::unique_ptr<Context> context;
    const auto wanted = [&](Backend kind) {
        return !context && (backend == kind || backend == Backend::automatic);
    };
    if (wanted(Backend::egl)) context = open_egl(failed);
    if (wanted(Backend::osmesa)) context = open_osmesa(failed);
    if (backend == Backend::glfw) context = open_glfw(failed);
    if (!context) throw Unavailable(std::move(failed));
    context->make_current();
    context->describe();
    return context;
}

Context::Context(std::string backend, Loader loader)
    : loader_(loader)
    , discarded_(std::make_shared<Discarded>()) {
    info_.backend = std::move(backend);
}

// What discarded_ still holds goes with the native context.
Context::~Context() = default;

void Context::make_current() {
    if (current_ == this) return;
    // With another back end's context still current, EGL takes the call for a change of nothing
    // and GL calls go on to the old context, in silence.
    if (current_) current_->release();
    bind();
    current_ = this;
    load_functions();
    discarded_->remove();
}

void Context::release() noexcept {
    if (current_ != this) return;
    unbind();
    current_ = nullptr;
}

void Context::expect_alive() const {
    // Only OpenGL 4.5 and later tell that a context is lost.
    if (!info_.has(4, 5) || !glGetGraphicsResetStatus) return;
    if (glGetGraphicsResetStatus() != GL_NO_ERROR) throw ContextLost();
}

void forget_functions() noexcept { loaded = nullptr; }

void Context::load_functions() {
    if (loaded == loader_) return;
    loaded = gladLoadGL(loader_) ? loader_ : nullptr;
    if (loaded) return;
    release();
    throw std::runtime_error(
        fmt::format("{}: the OpenGL functions cannot be loaded", info_.backend));
}

void Context::describe() {
    info_.vendor = text_of(GL_VENDOR);
    info_.renderer = text_of(GL_RENDERER);
    info_.version = text_of(GL_VERSION);
    info_.glsl_version = text_of(GL_SHADING_LANGUAGE_VERSION);
    info_.major = integer_of(GL_MAJOR_VERSION);
    info_.minor = integer_of(GL_MINOR_VERSION);
    info_.max_texture_size = integer_of(GL_MAX_TEXTURE_SIZE);
    info_.max_uniform_block_size = integer_of(GL_MAX_UNIFORM_BLOCK_SIZE);
    info_.max_texture_buffer_size = integer_of(GL_MAX_TEXTURE_BUFFER_SIZE);
    if (info_.has(4, 3)) {
        info_.max_storage_block_size = integer_of(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    }
    info_.software = draws_in_software(info_.renderer);
    info_.threads = info_.software ? drawing_threads() : 0;
}

} // namespace isomotion::gpu
