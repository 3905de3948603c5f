#include "gpu/backends.h"
#include "gpu/shared_library.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace isomotion::gpu {
namespace {

struct OsmesaState;
using OsmesaHandle = OsmesaState*;

// From GL/osmesa.h, which newer Mesa no longer ships; the library is optional for the same reason.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_rgba = 0x1908;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;
constexpr unsigned osmesa_unsigned_byte = 0x1401;

/// ISOMOTION_OSMESA names the library where it lies outside the loader's path.
SharedLibrary open_library() {
    if (const char* path = std::getenv("ISOMOTION_OSMESA")) return SharedLibrary{path};
    return SharedLibrary{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
}

struct Osmesa {
    using Procedure = void (*)();

    SharedLibrary library = open_library();
    OsmesaHandle (*create)(const int* attributes, OsmesaHandle shared) =
        library.find<OsmesaHandle(const int*, OsmesaHandle)>("OSMesaCreateContextAttribs");
    void (*destroy)(OsmesaHandle) = library.find<void(OsmesaHandle)>("OSMesaDestroyContext");
    unsigned char (*make_current)(OsmesaHandle, void*, unsigned, int, int) =
        library.find<unsigned char(OsmesaHandle, void*, unsigned, int, int)>("OSMesaMakeCurrent");
    Procedure (*get_proc_address)(const char*) =
        library.find<Procedure(const char*)>("OSMesaGetProcAddress");

    static const Osmesa& get() {
        static const Osmesa osmesa;
        return osmesa;
    }
};

class OsmesaContext final : public Context {
public:
    OsmesaContext()
        : Context("osmesa", [](const char* name) { return Osmesa::get().get_proc_address(name); }) {
        for (const auto& [major, minor] : wanted_versions) {
            const int attributes[] = {osmesa_format,
                                      osmesa_rgba,
                                      osmesa_profile,
                                      osmesa_core_profile,
                                      osmesa_major_version,
                                      major,
                                      osmesa_minor_version,
                                      minor,
                                      0};
            handle_ = osmesa_.create(attributes, nullptr);
            if (handle_) return;
        }
        throw std::runtime_error("OSMesaCreateContextAttribs refuses OpenGL 3.3 core");
    }

    ~OsmesaContext() override {
        release();
        osmesa_.destroy(handle_);
    }

private:
    void bind() override {
        if (!osmesa_.make_current(handle_, pixel_.data(), osmesa_unsigned_byte, 1, 1))
            throw std::runtime_error("OSMesaMakeCurrent failed");
    }

    void unbind() noexcept override { osmesa_.make_current(nullptr, nullptr, 0, 0, 0); }

    const Osmesa& osmesa_ = Osmesa::get();
    OsmesaHandle handle_ = nullptr;
    std::array<unsigned char, 4> pixel_{}; ///< the window it insists on; drawing goes to targets
};

} // namespace

std::unique_ptr<Context> open_osmesa(std::vector<Attempt>& failed) {
    try {
        return std::make_unique<OsmesaContext>();
    } catch (const std::runtime_error& error) {
        failed.push_back({"osmesa", error.what()});
        return nullptr;
    }
}

} // namespace isomotion::gpu
