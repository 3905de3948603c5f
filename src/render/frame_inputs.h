// All that a frame is drawn from, evaluated once: what is uploaded is what the fingerprint is taken
// of.
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
#include "render/element_radius.h"
#include "render/motion.h"
#include "render/proof_rays.h"
#include "render/uniform_blocks.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "synthesis/pass.h"
#include "synthesis/uniform.h"

namespace isomotion::render {

// What the names of the surface's formula stand for.
struct FieldInputs {
    std::vector<std::byte> parameters;          // block Parameters
    std::vector<std::vector<glm::vec4>> arrays; // the elements of each, packed
    std::optional<elements::ElementGrid> grid;  // of the array whose elements are found by place
};

// Rays, and the beams of blocks of them.
struct ViewInputs {
    FrameBlock frame;
    std::vector<glm::vec4> beams; // of each level: see beam_range()
};

// The picture that a light far away has of the bounds: light_beams.h.
struct LightInputs {
    int light = 0;
    ViewInputs view;
    std::array<glm::vec4, 4> to_light{}; // see shaders/effects/light_beam.glsl
};

// F at two times about the frame's, for the channel velocity.
struct MotionInputs {
    scene::SceneAt now;
    Motion motion;
    FrameBlock frame_before, frame_after; // where the camera and the surface are then
    FieldInputs before, after;
};

struct PictureInputs {
    int width = 0, height = 0;
    ViewInputs eye;
    std::shared_ptr<const FieldInputs> field; // that pictures of one time share
    std::vector<glm::vec4> shading;           // block Shading
    synthesis::Uniforms effects;
    std::vector<LightInputs> lights;
    std::optional<ProofRays> proofs;
    std::optional<MotionInputs> motion;
    scene::Aim aim; // which `eye` is of
    // Pixels, row by row from the top, ascending, whose endings are wanted; these decide no pixel.
    std::vector<int> endings_of{};
    std::chrono::duration<double> preparing{}; // the time it took; decides no pixel
    std::vector<PictureInputs> others{};       // of a scene's other surfaces

    glm::vec4 background() const { return shading[1]; }
    void add_to(base::Fingerprint& print) const;
};

// The grid of the elements that the picture's field finds by place; null if it looks at all.
std::shared_ptr<const elements::ElementGrid> grid(const PictureInputs& inputs);

struct FrameInputs {
    animation::Values values;            // of the animation, at the frame's time
    scene::SceneAt now;                  // the scene with these
    std::vector<PictureInputs> pictures; // at least one, the first at that time
    std::string fingerprint; // of these, the passes, size and channels; equal ones, equal pixels
};

// What inputs depend on beside the scene and the time.
struct InputLayout {
    const synthesis::Passes& passes;
    int width = 0, height = 0;
    int light_pixels = 0; // the side of lights' pictures
    // For the array whose elements are found by place, else null.
    const elements::GridMaker* grid = nullptr;
    elements::GridLimits grid_limits{};
    std::uint32_t most_elements_at_a_place = 0; // that a shader can sum
};

// `element_radius`: of rays that march by cubics; null for others.
ViewInputs view_inputs(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                       const scene::Aim& aim, const synthesis::Passes& passes,
                       ElementRadius* element_radius);

// The field's values that were made last, for pictures of the same elements and parameters.
class SharedField {
public:
    std::shared_ptr<const FieldInputs> at(const scene::Scene& scene, const scene::SceneAt& now,
                                          const InputLayout& layout);

private:
    std::optional<formula::Bindings<float>> of_;
    scene::BoundsAt bounds_;
    std::shared_ptr<const FieldInputs> made_;
};

// One picture. `element_radius` remembers between pictures of the same elements.
PictureInputs picture_inputs(const scene::Scene& scene, const scene::SceneAt& now,
                             const scene::Aim& aim, const Motion* motion, const InputLayout& layout,
                             ElementRadius& element_radius, SharedField& field);

} // namespace isomotion::render
