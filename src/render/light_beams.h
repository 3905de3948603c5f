// Beams of lights far away: for each that casts shadows a picture of the bounds as it sees them,
// drawn before the eye's, so that shadow rays begin where the surface first may be.
#pragma once

#include <vector>

#include "render/beam_pass.h"
#include "render/frame_inputs.h"

namespace isomotion::render {

// Pixels along the side of a light's picture, for pictures of this size.
int light_pixels(int width, int height);

// What the lights' pictures are drawn from, of each light that has one.
std::vector<LightInputs> light_inputs(const scene::Scene& scene, const scene::SceneAt& now,
                                      const synthesis::Passes& passes, int pixels);

class LightBeams {
public:
    // For passes that have some (Passes::light_beams), by the eye's beams' programs; pictures of
    // lights have up to so many pixels a side. Lists of elements follow the first `first_list`.
    LightBeams(const synthesis::Passes& passes, const scene::Scene& scene, int pixels, int texels,
               int first_list);

    int listed() const { return beams_.listed(); }
    int most_pixels() const { return most_pixels_; }

    // Draws the frame's, whose field is uploaded and bound, and binds them.
    void draw(PassTable& table, const std::vector<LightInputs>& lights, int pixels,
              const ArrayBuffer* array);
    // Binds those drawn last.
    void bind(const PassTable& table) const { beams_.bind(table, "light_beam"); }

private:
    int most_pixels_;
    BeamPass beams_;
    gpu::UniformBuffer frame_;
    std::vector<glm::vec4> to_light_; // of all lights: shaders/effects/light_beam.glsl
};

} // namespace isomotion::render
