// Frames as pictures, by OpenGL.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <isomotion/scene.h>

namespace isomotion {

// An OpenGL context, without a window that is seen. One that was moved from can only be assigned
// to.
class Device {
public:
    enum class Kind { automatic, egl, osmesa, window };
    explicit Device(Kind kind = Kind::automatic);
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;
    ~Device();
    std::string renderer() const; // what draws: a graphics card, or a program as llvmpipe
    std::string version() const;  // of OpenGL and its driver
    std::string backend() const;  // how it was opened: "egl-device", "osmesa", ...

    struct Parts; // for isomotion itself
    explicit Device(std::unique_ptr<Parts> parts);
    Parts& parts() const { return *parts_; }

private:
    std::unique_ptr<Parts> parts_;
};

// What the rays of a picture, or of many, found and took.
struct RayStatistics {
    // Rays from the eye by how they ended, over all samples.
    std::int64_t misses = 0, hits = 0, step_limits = 0, not_numbers = 0, zero_gradients = 0;
    struct Kind {
        std::string name;             // "eye", "shadow", "path" (mirrored, refracted), "occlusion"
        std::int64_t evaluations = 0; // of the field
        std::int64_t most = 0;        // of these, for one pixel of one sample
        std::int64_t undecided = 0;   // rays that reached their limit
    };
    std::vector<Kind> kinds = {};
    // Pixels by what was proved of them; empty unless the scene says isolation.certify.
    struct Proof {
        std::string name; // "hit", "miss"; of pixels that are not proved: why
        bool is_proved = false;
        std::int64_t pixels = 0;
    };
    std::vector<Proof> proofs = {};
    double seconds = 0; // of drawing

    std::int64_t rays() const; // from the eye
    std::int64_t evaluations() const;
};

// A drawn frame.
struct Picture : RayStatistics {
    // A number for each pixel, row by row from the top.
    struct Plane {
        std::string name; // R G B: linear light times A; A; and those of the channels asked for
        std::vector<float> values;
    };
    int width = 0, height = 0;
    std::vector<Plane> planes;

    // Null if there is no such plane.
    const Plane* find(std::string_view name) const;
    // sRGB, 8 bits, not premultiplied: R G B A for each pixel, row by row from the top.
    std::vector<std::uint8_t> rgba8() const;
    // A hash of the samples of all planes.
    std::string fingerprint() const;
    // A .png of the colours, or an .exr of all planes. The file appears when it is whole.
    void write(const std::filesystem::path& file) const;
};

struct RenderSettings {
    int width = 0, height = 0;              // 0: the scene's
    std::vector<std::string> channels = {}; // "z", "n", "verdict", ...: docs/rendering.md
    // Of the shaders that march rays: "compute", or "auto" for the faster here.
    std::string stage = "fragment";
};

// Draws frames of one scene, whose shaders are compiled once. Frames beyond the scene's last are
// there, too. One that was moved from can only be assigned to.
class Renderer {
public:
    // The device must outlive it.
    Renderer(Device& device, const Scene& scene, const RenderSettings& settings = {},
             Watcher watcher = {});
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();
    // `so_far` is given the mean after each sample of the frame.
    Picture draw(int frame, const std::function<void(const Picture&)>& so_far = {});

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// The head of a fragment or compute shader, from its #version (3.30) on, in which are
//     float field(vec3 p);
//     vec3 field_gradient(vec3 p);
//     uniform vec4 parameters[]; of the formula by name: the first is parameters[0].x
// with the functions that they call. Numbers are of 32 bits: beyond 1e30 they stay there.
std::string glsl_of(const Formula& formula);

} // namespace isomotion
