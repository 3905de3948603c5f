// All data that a frame is drawn from, evaluated once. The fingerprint is taken of exactly the data
// that is uploaded.
//
// A frame is one picture, or the mean of several (exposure.h), each with its own place in the
// pixel, point of the lens and time while the shutter is open.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "base/fingerprint.h"
#include "elements/grid_maker.h"
#include "formula/tape/tape_cells.h"
#include "render/element_radius.h"
#include "render/motion.h"
#include "render/proof_rays.h"
#include "render/uniform_blocks.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "shader/pass.h"
#include "shader/uniform.h"

namespace isomotion::render {

// The values of the formula's names.
struct FieldInputs {
    std::vector<std::byte> parameters;          // block Parameters
    std::vector<std::vector<glm::vec4>> arrays; // the elements of each, packed
    std::optional<elements::ElementGrid> grid;  // of the array whose elements are found by place
    std::optional<formula::TapeCells> tapes;    // of the functions that an interpreter runs
};

// Rays, and the beams of blocks of them.
struct ViewInputs {
    FrameBlock frame;
    std::vector<glm::vec4> beams; // for each level: see beam_range()
};

// The view of the bounds from a distant light: light_beams.h.
struct LightInputs {
    int light = 0;
    ViewInputs view;
    std::array<glm::vec4, 4> to_light{}; // see shaders/effects/light_beam.glsl
};

// F at two times around the frame's time, for the channel velocity.
struct MotionInputs {
    FrameBlock frame_before, frame_after; // the camera and the surface at those times
    FieldInputs before, after;
};

// One surface of a picture.
struct SurfaceInputs {
    ViewInputs eye;
    std::shared_ptr<const FieldInputs> field; // shared by pictures of one time
    std::vector<glm::vec4> shading;           // block Shading
    shader::Uniforms effects;
    std::vector<LightInputs> lights;
    std::optional<ProofRays> proofs;
    std::optional<MotionInputs> motion;
};

struct PictureInputs {
    int width = 0, height = 0;
    std::vector<SurfaceInputs> surfaces; // as the scene lists them
    // For velocities: the picture's time, and those around it.
    struct Moving {
        scene::SceneAt now;
        Motion about;
    };
    std::optional<Moving> moving{};
    scene::Aim aim{}; // of the eye; decides no pixel that `surfaces` doesn't
    // Pixels whose endings are wanted, row by row from the top, ascending. They don't affect
    // pixels.
    std::vector<int> endings_of{};
    // The time that preparation took; doesn't affect pixels.
    std::chrono::duration<double> preparing{};

    glm::vec4 background() const { return surfaces.front().shading[1]; }
    void add_to(base::Fingerprint& print) const;
};

// The grid by which the surface's field finds its elements; null if it sums over all elements.
std::shared_ptr<const elements::ElementGrid> grid(const SurfaceInputs& inputs);

struct FrameInputs {
    scene::SceneAt now;                  // the scene at the frame's time
    std::vector<PictureInputs> pictures; // at least one; the first is at the frame's time
    std::string fingerprint; // of these inputs, the passes, size and channels; equal fingerprints
                             // mean equal pixels
};

// What inputs depend on besides the scene and the time.
struct InputLayout {
    const shader::Passes& passes;
    int width = 0, height = 0;
    int light_pixels = 0; // pixels along the sides of lights' pictures
    // For the array whose elements are found by place, otherwise null.
    const elements::GridMaker* grid = nullptr;
    elements::GridLimits grid_limits{};
    formula::TapeLimits tape_limits{};
    // Limit of the elements that a shader can sum at a place.
    std::uint32_t most_elements_at_a_place = 0;
};

// `element_radius`: for rays that march by cubics, otherwise null.
ViewInputs view_inputs(const scene::OneSurface& one, const scene::OneSurfaceAt& now, int width,
                       int height, const scene::Aim& aim, const shader::Passes& passes,
                       ElementRadius* element_radius);

// The field's values made last, reused for pictures with the same elements and parameters.
class SharedField {
public:
    std::shared_ptr<const FieldInputs> at(const formula::Field& field, const scene::SurfaceAt& now,
                                          const InputLayout& layout);

private:
    std::optional<formula::Bindings<float>> of_;
    scene::BoundsAt bounds_;
    std::shared_ptr<const FieldInputs> made_;
};

// Inputs of a surface in one picture. `motion`: for velocities, otherwise null. `element_radius` is
// cached between pictures of the same elements.
SurfaceInputs surface_inputs(const scene::OneSurface& one, const scene::OneSurfaceAt& now,
                             const scene::Aim& aim, const Motion* motion, const InputLayout& layout,
                             ElementRadius& element_radius, SharedField& field);

} // namespace isomotion::render
