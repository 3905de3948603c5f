// libEGL with faults: hands every call on to the real library, but fails as a driver may where
// FAULT in the environment says so:
//   context   no context can be made
//   compile   no shader compiles
//   link      no program links
//   memory    no texture of 32 pixels or more across can be had
//   readback  pixels cannot be read back from the third time on
//   small     textures are 64 pixels across at most
#include <dlfcn.h>

#include <cstdlib>
#include <string_view>

using Procedure = void (*)();

namespace {

constexpr unsigned gl_out_of_memory = 0x0505, gl_compile_status = 0x8B81, gl_link_status = 0x8B82,
                   gl_max_texture_size = 0x0D33;

unsigned pending_error = 0;

bool fails(std::string_view what) {
    const char* fault = std::getenv("FAULT");
    return fault && fault == what;
}

void* real_library() {
    // With its folder: the bare name would find this library again.
    static void* const library = [] {
        void* found = dlopen(std::getenv("REAL_EGL"), RTLD_NOW | RTLD_LOCAL);
        if (!found) std::abort();
        return found;
    }();
    return library;
}

template<class Function> Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(real_library(), name));
}

using GetError = unsigned (*)();
using GetInteger = void (*)(unsigned, int*);
using GetIv = void (*)(unsigned, unsigned, int*);
using TexImage = void (*)(unsigned, int, int, int, int, int, unsigned, unsigned, const void*);
using ReadPixels = void (*)(int, int, int, int, unsigned, unsigned, void*);

GetError real_get_error;
GetInteger real_get_integer;
GetIv real_get_shader, real_get_program;
TexImage real_tex_image;
ReadPixels real_read_pixels;

unsigned get_error() {
    if (const unsigned error = pending_error) {
        pending_error = 0;
        return error;
    }
    return real_get_error();
}

void get_integer(unsigned name, int* value) {
    real_get_integer(name, value);
    if (name == gl_max_texture_size && fails("small")) *value = 64;
}

void get_shader(unsigned shader, unsigned name, int* value) {
    real_get_shader(shader, name, value);
    if (name == gl_compile_status && fails("compile")) *value = 0;
}

void get_program(unsigned program, unsigned name, int* value) {
    real_get_program(program, name, value);
    if (name == gl_link_status && fails("link")) *value = 0;
}

void tex_image(unsigned target, int level, int internal, int width, int height, int border,
               unsigned format, unsigned type, const void* pixels) {
    if (fails("memory") && width >= 32) {
        pending_error = gl_out_of_memory;
        return;
    }
    real_tex_image(target, level, internal, width, height, border, format, type, pixels);
}

void read_pixels(int x, int y, int width, int height, unsigned format, unsigned type, void* to) {
    static int times = 0;
    if (fails("readback") && ++times >= 3) {
        pending_error = gl_out_of_memory;
        return;
    }
    real_read_pixels(x, y, width, height, format, type, to);
}

template<class Function> Procedure instead(Procedure found, Function& kept_real, Function ours) {
    kept_real = reinterpret_cast<Function>(found);
    return reinterpret_cast<Procedure>(ours);
}

} // namespace

extern "C" {

Procedure eglGetProcAddress(const char* name) {
    const Procedure found = real<Procedure (*)(const char*)>("eglGetProcAddress")(name);
    const std::string_view wanted = name;
    if (wanted == "glGetError") return instead(found, real_get_error, &get_error);
    if (wanted == "glGetIntegerv") return instead(found, real_get_integer, &get_integer);
    if (wanted == "glGetShaderiv") return instead(found, real_get_shader, &get_shader);
    if (wanted == "glGetProgramiv") return instead(found, real_get_program, &get_program);
    if (wanted == "glTexImage2D") return instead(found, real_tex_image, &tex_image);
    if (wanted == "glReadPixels") return instead(found, real_read_pixels, &read_pixels);
    return found;
}

int eglGetError() { return real<int (*)()>("eglGetError")(); }

const char* eglQueryString(void* display, int name) {
    return real<const char* (*)(void*, int)>("eglQueryString")(display, name);
}

unsigned eglInitialize(void* display, int* major, int* minor) {
    return real<unsigned (*)(void*, int*, int*)>("eglInitialize")(display, major, minor);
}

unsigned eglBindAPI(unsigned api) { return real<unsigned (*)(unsigned)>("eglBindAPI")(api); }

unsigned eglChooseConfig(void* display, const int* wanted, void** configs, int size, int* count) {
    return real<unsigned (*)(void*, const int*, void**, int, int*)>("eglChooseConfig")(
        display, wanted, configs, size, count);
}

void* eglCreateContext(void* display, void* config, void* shared, const int* attributes) {
    if (fails("context")) return nullptr;
    return real<void* (*)(void*, void*, void*, const int*)>("eglCreateContext")(display, config,
                                                                                shared, attributes);
}

unsigned eglDestroyContext(void* display, void* context) {
    return real<unsigned (*)(void*, void*)>("eglDestroyContext")(display, context);
}

void* eglCreatePbufferSurface(void* display, void* config, const int* attributes) {
    return real<void* (*)(void*, void*, const int*)>("eglCreatePbufferSurface")(display, config,
                                                                                attributes);
}

unsigned eglDestroySurface(void* display, void* surface) {
    return real<unsigned (*)(void*, void*)>("eglDestroySurface")(display, surface);
}

unsigned eglMakeCurrent(void* display, void* draw, void* read, void* context) {
    return real<unsigned (*)(void*, void*, void*, void*)>("eglMakeCurrent")(display, draw, read,
                                                                            context);
}

} // extern "C"
