#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isomotion/error.h>

struct GLFWwindow;

namespace isomotion::gpu {

struct Discarded;
class Name;

enum class Backend { automatic, egl, osmesa, glfw };

/// Throws std::invalid_argument that lists the valid names.
Backend parse_backend(std::string_view text);
std::string_view name(Backend backend);

struct ContextInfo {
    std::string backend; ///< how it was opened: "egl-device", "egl-surfaceless", "osmesa", "glfw"
    std::string vendor, renderer, version, glsl_version;
    int major = 0, minor = 0;
    bool has(int wanted_major, int wanted_minor) const {
        return major > wanted_major || (major == wanted_major && minor >= wanted_minor);
    }
    int max_texture_size = 0;
    int max_uniform_block_size = 0;  ///< bytes
    int max_texture_buffer_size = 0; ///< texels
    int max_storage_block_size = 0;  ///< bytes; 0 before OpenGL 4.3
    bool software = false;
    int threads = 0; ///< among which a software renderer shares its drawing; 0 of hardware
};

/// One back end that was tried and did not work.
struct Attempt {
    std::string what;
    std::string reason;
};

/// No context is available. The message lists every attempt and what to install.
class Unavailable : public Error {
public:
    explicit Unavailable(std::vector<Attempt> attempts);
    const std::vector<Attempt>& attempts() const noexcept { return attempts_; }

private:
    std::vector<Attempt> attempts_;
};

/// An OpenGL core context: 4.5 if the driver has it, at least 3.3.
///
/// The GL functions are those of the back end whose context was made current last in the process.
/// So draw from one thread, or from several with contexts of one back end, the first of which was
/// current before the other threads began. (llvmpipe gains nothing from several threads; processes
/// scale.)
class Context {
public:
    /// Returns a context that is current on this thread. `automatic` uses a graphics card if there
    /// is one, and no display; `glfw` uses a hidden window. Throws Unavailable.
    static std::unique_ptr<Context> create(Backend backend = Backend::automatic);

    /// The context current on this thread, or null.
    static Context* current() noexcept { return current_; }

    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context();

    void make_current();
    void release() noexcept;

    /// Throws ContextLost if the driver was reset since the context was made. The context must be
    /// current.
    void expect_alive() const;

    const ContextInfo& info() const noexcept { return info_; }

    /// Keeps something until the first picture is read back: until then drivers load and compile,
    /// which is when they crash.
    void keep_until_drawn(std::shared_ptr<void> kept) noexcept { until_drawn_ = std::move(kept); }
    void has_drawn() noexcept { until_drawn_.reset(); }

protected:
    using Procedure = void (*)();
    using Loader = Procedure (*)(const char* name);

    /// `loader` finds the GL functions of the back end.
    Context(std::string backend, Loader loader);

private:
    friend class Name;
    friend std::unique_ptr<Context> context_of(GLFWwindow* window);

    /// A back end's destructor must call release() while these functions are still its own.
    virtual void bind() = 0;
    virtual void unbind() noexcept = 0;

    void load_functions();
    void describe();

    static thread_local Context* current_;

    ContextInfo info_;
    Loader loader_;
    std::shared_ptr<Discarded> discarded_;
    std::shared_ptr<void> until_drawn_;
};

} // namespace isomotion::gpu
