// Beams of lights far away: for each that casts shadows a picture of the bounds as it sees them,
// drawn before the eye's, so that shadow rays begin where the surface first may be.
#pragma once

#include "gpu/buffer.h"
#include "render/beam_pass.h"

namespace isomotion::render {

class LightBeams {
public:
    // Of shaders that have some (Shaders::light_beams), with the eye's beams' programs. Lists of
    // elements follow the eye's, as far as `texels` of the array's buffer go.
    LightBeams(const BeamPass& eye, const synthesis::Shaders& shaders, int lights, int width,
               int height, int texels);

    int listed() const { return beams_.listed(); }
    // For pictures of another size; finer than at first the beams don't get.
    void resize(int width, int height);

    // Draws the frame's; the field's values are uploaded and bound. `binding` is that of the block
    // Frame, which is left changed, as the uniforms are that the eye's beams have.
    void draw(const scene::Scene& scene, const scene::SceneAt& now, unsigned binding,
              const ArrayBuffer* array);
    // For a program of shadow rays: textures from `unit` on.
    void connect(const gpu::Program& program, int unit) const;
    void bind(int unit) const { beams_.bind(unit); }
    // Sets what draw() made of the lights' views.
    void set_views(const gpu::Program& program) const;

private:
    int mask_, most_, pixels_; // of a picture's side
    BeamPass beams_;
    gpu::UniformBuffer frame_;
    std::vector<glm::vec4> views_; // see shaders/effects/light_beam.glsl
};

} // namespace isomotion::render
