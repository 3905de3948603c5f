#include "gpu/backends.h"
#include "gpu/shared_library.h"

// Only the types: every function is looked up at run time.
#define EGL_EGL_PROTOTYPES 0
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace isomotion::gpu {
namespace {

struct Egl {
    template<typename Pointer>
    static Pointer extension(PFNEGLGETPROCADDRESSPROC find, const char* name) {
        return reinterpret_cast<Pointer>(find(name));
    }

    SharedLibrary library{"libEGL.so.1", "libEGL.so"};

    template<typename Pointer> Pointer core(const char* name) const {
        return library.find<std::remove_pointer_t<Pointer>>(name);
    }

    PFNEGLGETPROCADDRESSPROC get_proc_address = core<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");
    PFNEGLGETERRORPROC get_error = core<PFNEGLGETERRORPROC>("eglGetError");
    PFNEGLQUERYSTRINGPROC query_string = core<PFNEGLQUERYSTRINGPROC>("eglQueryString");
    PFNEGLINITIALIZEPROC initialize = core<PFNEGLINITIALIZEPROC>("eglInitialize");
    PFNEGLBINDAPIPROC bind_api = core<PFNEGLBINDAPIPROC>("eglBindAPI");
    PFNEGLCHOOSECONFIGPROC choose_config = core<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig");
    PFNEGLCREATECONTEXTPROC create_context = core<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
    PFNEGLDESTROYCONTEXTPROC destroy_context = core<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
    PFNEGLCREATEPBUFFERSURFACEPROC create_pbuffer =
        core<PFNEGLCREATEPBUFFERSURFACEPROC>("eglCreatePbufferSurface");
    PFNEGLDESTROYSURFACEPROC destroy_surface = core<PFNEGLDESTROYSURFACEPROC>("eglDestroySurface");
    PFNEGLMAKECURRENTPROC make_current = core<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");

    // Null where the extension is missing.
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
        extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_proc_address, "eglGetPlatformDisplayEXT");
    PFNEGLQUERYDEVICESEXTPROC query_devices =
        extension<PFNEGLQUERYDEVICESEXTPROC>(get_proc_address, "eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string =
        extension<PFNEGLQUERYDEVICESTRINGEXTPROC>(get_proc_address, "eglQueryDeviceStringEXT");

    static const Egl& get() {
        static const Egl egl;
        return egl;
    }
};

std::string last_error() {
    static const std::map<EGLint, const char*> names = {
        {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
        {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
        {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
        {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
        {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
        {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
        {EGL_BAD_DEVICE_EXT, "EGL_BAD_DEVICE_EXT"},
        {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
        {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
        {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
        {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
    };
    const EGLint code = Egl::get().get_error();
    if (code == EGL_SUCCESS) return "no vendor library offers it";
    const auto found = names.find(code);
    return found != names.end() ? found->second : fmt::format("EGL error {:#06x}", code);
}

[[noreturn]] void fail(std::string_view call) {
    throw std::runtime_error(fmt::format("{} failed: {}", call, last_error()));
}

bool has(const char* list, std::string_view extension) {
    std::string_view rest = list ? list : "";
    while (!rest.empty()) {
        const auto end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == extension) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// A display ready for use. None is ever terminated: that would end all contexts of its device, and
/// Mesa unloads its driver then, to load it again for the next context.
EGLDisplay open_display(EGLenum platform, void* native) {
    const Egl& egl = Egl::get();
    const EGLDisplay display = egl.get_platform_display(platform, native, nullptr);
    if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplay");
    if (!egl.initialize(display, nullptr, nullptr)) fail("eglInitialize");
    return display;
}

class EglContext final : public Context {
public:
    EglContext(std::string backend, EGLDisplay display)
        : Context(std::move(backend),
                  [](const char* name) -> Procedure { return Egl::get().get_proc_address(name); })
        , display_(display) {
        if (!egl_.bind_api(EGL_OPENGL_API)) fail("eglBindAPI(EGL_OPENGL_API)");
        const bool surfaceless = offers("EGL_KHR_surfaceless_context");
        if (!surfaceless || !offers("EGL_KHR_no_config_context")) choose_config();
        create_context();
        if (!surfaceless) create_surface();
    }

    ~EglContext() override { destroy(); }

private:
    bool offers(std::string_view extension) const {
        return has(egl_.query_string(display_, EGL_EXTENSIONS), extension);
    }

    void choose_config() {
        constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                     EGL_OPENGL_BIT, EGL_NONE};
        EGLint found = 0;
        if (!egl_.choose_config(display_, wanted, &config_, 1, &found)) fail("eglChooseConfig");
        if (found == 0) throw std::runtime_error("no configuration can draw OpenGL off screen");
    }

    void create_context() {
        for (const auto& [major, minor] : wanted_versions) {
            const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                         major,
                                         EGL_CONTEXT_MINOR_VERSION_KHR,
                                         minor,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                         EGL_NONE};
            context_ = egl_.create_context(display_, config_, EGL_NO_CONTEXT, attributes);
            if (context_ != EGL_NO_CONTEXT) return;
        }
        fail("eglCreateContext for OpenGL 3.3 core");
    }

    void create_surface() {
        constexpr EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface_ = egl_.create_pbuffer(display_, config_, size);
        if (surface_ != EGL_NO_SURFACE) return;
        const std::string reason = last_error();
        destroy();
        throw std::runtime_error("eglCreatePbufferSurface failed: " + reason);
    }

    void destroy() noexcept {
        release();
        if (surface_ != EGL_NO_SURFACE) egl_.destroy_surface(display_, surface_);
        if (context_ != EGL_NO_CONTEXT) egl_.destroy_context(display_, context_);
    }

    void bind() override {
        // The bound API is this thread's, not the context's.
        egl_.bind_api(EGL_OPENGL_API);
        if (!egl_.make_current(display_, surface_, surface_, context_)) fail("eglMakeCurrent");
    }

    void unbind() noexcept override {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

    const Egl& egl_ = Egl::get();
    EGLDisplay display_;
    EGLConfig config_ = EGL_NO_CONFIG_KHR;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

/// One way to a display, named as the list of attempts names it.
struct Route {
    std::string backend;
    std::string label;
    EGLenum platform;
    void* native;
};

/// Graphics cards, then whatever the surfaceless platform takes, then devices that are software.
/// Surfaceless first would find Mesa's software on a machine whose card has a driver of its own.
std::vector<Route> routes() {
    const Egl& egl = Egl::get();
    if (!egl.get_platform_display)
        throw std::runtime_error("EGL_EXT_platform_base is missing in the library");
    std::vector<Route> cards, others;
    others.push_back(
        {"egl-surfaceless", "egl, surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr});

    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    const bool listed = egl.query_devices && egl.query_device_string &&
                        egl.query_devices(EGLint(devices.size()), devices.data(), &count);
    for (EGLint i = 0; listed && i < count; ++i) {
        const char* extensions = egl.query_device_string(devices[i], EGL_EXTENSIONS);
        const bool software = has(extensions, "EGL_MESA_device_software");
        (software ? others : cards)
            .push_back({"egl-device",
                        fmt::format("egl, device {} ({})", i, software ? "software" : "hardware"),
                        EGL_PLATFORM_DEVICE_EXT, devices[i]});
    }
    cards.insert(cards.end(), others.begin(), others.end());
    return cards;
}

} // namespace

std::unique_ptr<Context> open_egl(std::vector<Attempt>& failed) {
    try {
        for (const Route& route : routes()) {
            try {
                return std::make_unique<EglContext>(route.backend,
                                                    open_display(route.platform, route.native));
            } catch (const std::runtime_error& error) {
                failed.push_back({route.label, error.what()});
            }
        }
    } catch (const std::runtime_error& error) {
        failed.push_back({"egl", error.what()});
    }
    return nullptr;
}

} // namespace isomotion::gpu
