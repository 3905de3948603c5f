// Draws frames of one scene: compiled once, then only uniform values change.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/context.h"
#include "image/frame.h"
#include "render/frame_inputs.h"
#include "render/march_plan.h"
#include "render/motion.h"
#include "render/proofs.h"
#include "render/record.h"
#include "render/stage.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "synthesis/assemble.h"
#include "synthesis/channel.h"

namespace isomotion::render {

// Where a pixel's ray ended: t on its ray (scene/rays.h) of a hit, or one of those below.
struct Ending {
    int column = 0, row = 0; // from the top
    float t = 0;

    bool is_hit() const { return t != nowhere && t != unknown; }
    bool is_known() const { return t != unknown; } // neither NaN nor out of steps

    static constexpr float nowhere = 1e30f, unknown = -1e30f; // shaders/march/verdict.glsl
};

// A finished picture and what its rays went through.
struct Picture {
    image::Frame frame;                     // R G B A and the channels asked for; no metadata
    std::array<std::int64_t, 5> verdicts{}; // rays by Verdict
    std::int64_t evaluations = 0;           // of the field, all rays together
    ProofCounts proofs{};                   // pixels by Proof; none unless certified
    std::vector<Ending> endings;            // of the pixels that the inputs ask for
    int passes = 0;                         // march draws, all tiles together
    bool compiled = false;                  // a shader, the first time that one draw is too few
    // Preparing its inputs, upload to read-back; of one that was asked for and taken, those alone.
    std::chrono::duration<double> drawing{};
};

struct RenderOptions {
    int width = 0, height = 0;
    std::vector<synthesis::Channel> channels{};
    // Instead of the plan made from the formula's cost; tests show that it changes no pixel.
    std::optional<MarchPlan> plan{};
    // Told what was mended of the files that the scene names.
    std::function<void(const std::string&)> warn = {};
    // What marches the rays; it changes hits by last bits at most.
    StageChoice stage = StageChoice::fragment;
    // Pixels across the smallest beams: 8, or 1 to measure what closer starts would be worth.
    int finest_beam = synthesis::usual_beam;
    // Whether what float32 can't prove is tried in doubles, where the driver's can be trusted.
    bool proofs_in_doubles = true;
    // Whether inputs may ask for the endings of rays. It changes no pixel.
    bool tells_endings = false;
    // That find elements by place; 0: as many as the machine runs at once.
    int threads = 0;
    // Asked before each tile and between its passes; where it says true, draw() throws Stopped.
    std::function<bool()> stop = {};
    // Told then: the part of the picture that is drawn, in whole tiles.
    std::function<void(double part)> progress = {};
};

// A picture that was given up.
struct Stopped {};

class Renderer {
public:
    // Compiles the scene's shaders in `context`, which must outlive the renderer. Throws
    // gpu::CompileError, gpu::ResourceError, std::length_error (a sum too long for a shader).
    Renderer(gpu::Context& context, const scene::Scene& scene, RenderOptions options);
    ~Renderer();

    // Evaluates a frame: everything that drawing it takes, and the fingerprint of that. The scene's
    // animation may be another than the renderer's own. Throws SceneError where a value leaves its
    // range.
    FrameInputs prepare(const scene::Scene& scene, int frame) const;
    // Evaluates one picture, a ray a pixel. The channel velocity needs `motion`.
    PictureInputs prepare(const scene::SceneAt& now, const scene::Aim& aim = {},
                          const Motion* motion = nullptr) const;

    // Throws std::logic_error for inputs that were prepared for another size.
    Picture draw(const PictureInputs& inputs);
    Picture draw(const scene::SceneAt& now, const scene::Aim& aim = {},
                 const Motion* motion = nullptr) {
        return draw(prepare(now, aim, motion));
    }
    // The same in two steps: start() asks for a picture, take() gives the one asked for first, and
    // as many may be on their way as most_in_flight() says, 1 or 2. If either throws, none is any
    // more. Both throw std::logic_error out of turn, draw() where any is on its way.
    void start(PictureInputs inputs);
    void start(const scene::SceneAt& now, const scene::Aim& aim = {},
               const Motion* motion = nullptr) {
        start(prepare(now, aim, motion));
    }
    Picture take();
    int in_flight() const;
    int most_in_flight() const;
    // Gives back a picture's memory, for the next one.
    void reuse(Picture picture);

    // The size of the next pictures. Nothing is compiled or made anew, so it costs nothing;
    // pictures larger than the options' are cut into more tiles, for which the options' sides must
    // be multiples of 64, or else this throws std::invalid_argument.
    void resize(int width, int height);
    // Other settings of the scene's method, for the next pictures; those of other surfaces change
    // alike. Throws std::invalid_argument for another method, beams or proofs: those are other
    // shaders.
    void adjust(const scene::Isolation& settings);
    bool needs_motion() const;
    // From the next picture on rays begin where the beams of the one drawn last have them, until
    // it is called off: right for that picture's time and aim alone, to measure what starts cost.
    // Throws std::logic_error if pictures take more than one tile.
    void keep_beams(bool keep);

    // Changes with the text of any shader.
    const std::string& shaders_fingerprint() const;
    const MarchPlan& plan() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace isomotion::render
