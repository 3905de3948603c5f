// Draws frames of one scene. The scene is compiled once; then only uniform values change.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <isomotion/error.h>

#include "gpu/context.h"
#include "image/frame.h"
#include "render/frame_inputs.h"
#include "render/march_plan.h"
#include "render/motion.h"
#include "render/proofs.h"
#include "render/ray_counts.h"
#include "render/record.h"
#include "render/stage.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "shader/assemble.h"
#include "shader/channel.h"

namespace isomotion::render {

// Where a pixel's ray ended: t on its ray (scene/rays.h) for a hit, or one of the constants below.
struct Ending {
    int column = 0, row = 0; // from the top
    float t = 0;

    bool is_hit() const { return t != nowhere && t != unknown; }
    bool is_known() const { return t != unknown; } // neither NaN nor out of steps

    static constexpr float nowhere = 1e30f, unknown = -1e30f; // shaders/march/verdict.glsl
};

// A finished picture with statistics of its rays.
struct Picture {
    image::Frame frame;                     // R G B A and the requested channels; no metadata
    std::array<std::int64_t, 5> verdicts{}; // rays by Verdict
    RayCounts rays{};                       // what each kind of ray took
    ProofCounts proofs{};                   // pixels by Proof; empty unless certified
    std::vector<Ending> endings;            // for the pixels that the inputs ask for
    int passes = 0;                         // march draws of all tiles
    bool compiled = false; // a shader was compiled, the first time that one draw was not enough
    // Of the field, for all rays together.
    std::int64_t evaluations() const { return render::evaluations(rays); }
    // From preparing its inputs to read-back. For a picture that was started and taken, the time of
    // these two calls alone.
    std::chrono::duration<double> drawing{};
    // The GPU's time for beams and rays, if the options ask for it; in fragment shaders that march
    // and shade in one draw, for shading, too.
    std::chrono::duration<double> marching{};
};

struct RenderOptions {
    int width = 0, height = 0;
    std::vector<shader::Channel> channels{};
    // Replaces the plan made from the formula's cost. Tests show that it changes no pixel.
    std::optional<MarchPlan> plan{};
    // Receives messages on repaired data in files that the scene names.
    std::function<void(const std::string&)> warn = {};
    // The stage that marches rays. It changes at most the last bits of hits.
    StageChoice stage = StageChoice::fragment;
    // Pixels of the pictures that shaders are chosen for; 0: those of the options' size. It changes
    // at most the last bits of hits.
    std::int64_t pixels = 0;
    // Pixels across the smallest beams: 8, or 1 to measure the benefit of closer starts.
    int finest_beam = shader::usual_beam;
    // Whether proofs that fail in float32 are tried in doubles, where the driver's can be trusted.
    bool proofs_in_doubles = true;
    // Whether inputs may ask for the endings of rays. It changes no pixel.
    bool tells_endings = false;
    // Whether draw() measures the GPU's time for beams and rays, for which it waits.
    bool times_rays = false;
    // Whether pictures are read back at once, as hardware is best asked, or in parts; by default as
    // the context's renderer is. It changes no pixel.
    std::optional<bool> reads_at_once{};
    // Whether steps of rays branch, which graphics cards gain by; by default as the context's
    // renderer does. It changes at most the last bits of hits.
    std::optional<bool> branches{};
    // Threads that make grids of elements and copy pixels; 0: as many as the machine runs at once.
    int threads = 0;
    // Called before each tile and between its passes; if it returns true, draw() throws Stopped.
    std::function<bool()> stop = {};
    // Called at the same times, and once a picture is drawn, with its finished part in whole tiles.
    std::function<void(double part)> progress = {};
};

// Thrown when a picture is stopped.
struct Stopped : Error {
    Stopped()
        : Error(Code::stopped, "stopped") {}
};

class Renderer {
public:
    // Compiles the scene's shaders in `context`, which must outlive the renderer. Throws
    // gpu::CompileError, gpu::ResourceError, std::length_error (a sum too long for a shader).
    Renderer(gpu::Context& context, const scene::Scene& scene, RenderOptions options);
    ~Renderer();

    // Evaluates a frame: all inputs of its drawing, and their fingerprint. The animation of `scene`
    // may differ from the renderer's own. Throws SceneError if a value leaves its range.
    FrameInputs prepare(const scene::Scene& scene, int frame) const;
    // Evaluates one picture with one ray per pixel. The channel velocity needs `motion`.
    PictureInputs prepare(const scene::SceneAt& now, const scene::Aim& aim = {},
                          const Motion* motion = nullptr) const;

    // Throws std::logic_error for inputs that were prepared for another size.
    Picture draw(const PictureInputs& inputs);
    Picture draw(const scene::SceneAt& now, const scene::Aim& aim = {},
                 const Motion* motion = nullptr) {
        return draw(prepare(now, aim, motion));
    }
    // The same in two steps: start() begins a picture, and take() returns the one that was begun
    // first. At most most_in_flight() pictures, 1 or 2, may be in flight. If either throws, none is
    // any more. Both throw std::logic_error when called out of turn, and so does draw() while any
    // is in flight.
    void start(PictureInputs inputs);
    void start(const scene::SceneAt& now, const scene::Aim& aim = {},
               const Motion* motion = nullptr) {
        start(prepare(now, aim, motion));
    }
    Picture take();
    int in_flight() const;
    int most_in_flight() const;
    // Reuses a picture's memory for the next one.
    void reuse(Picture picture);

    // Sets the size of the next pictures. Nothing is compiled or allocated, so it costs nothing:
    // shaders stay those of the options' pixels.
    // Pictures larger than the options' size are cut into more tiles. For that the options' sides
    // must be multiples of 64, otherwise this throws std::invalid_argument.
    void resize(int width, int height);
    // Sets the method's settings for the next pictures; settings of other surfaces change in the
    // same way. Throws std::invalid_argument for another method, beams or proofs, which need other
    // shaders.
    void adjust(const scene::Isolation& settings);
    bool needs_motion() const;
    // If true, rays of later pictures begin where the beams of the last picture have them, until
    // called with false. This is correct only for that picture's time and aim; it serves to measure
    // the cost of starts. Throws std::logic_error if pictures take more than one tile.
    void keep_beams(bool keep);

    // Changes with the code of any shader.
    const std::string& shaders_fingerprint() const;
    const MarchPlan& plan() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace isomotion::render
