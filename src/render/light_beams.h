// Beams of distant lights. For each one that casts shadows the bounds are drawn as seen from the
// light, before the eye's view, so that shadow rays begin where the surface may begin.
#pragma once

#include <vector>

#include "render/beam_pass.h"
#include "render/frame_inputs.h"

namespace isomotion::render {

// Pixels along the sides of a light's picture, for pictures of this size.
int light_pixels(int width, int height);

// Inputs for the pictures of all lights that have one.
std::vector<LightInputs> light_inputs(const scene::OneSurface& one, const scene::OneSurfaceAt& now,
                                      const shader::Passes& passes, int pixels);

class LightBeams {
public:
    // For passes with light beams (Passes::light_beams), drawn by the programs of the eye's beams.
    // Pictures of lights have at most so many pixels per side. Lists of elements start at
    // `first_list`.
    LightBeams(const shader::Passes& passes, const scene::OneSurface& one, int pixels, int texels,
               int first_list);

    int listed() const { return beams_.listed(); }
    int most_pixels() const { return most_pixels_; }

    // Draws and binds the light beams of a frame whose field is uploaded and bound.
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
