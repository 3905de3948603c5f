// Shaders that find which part of their way rays need to march, block of pixels by block, and how
// rays learn of it: see render/beam_pass.h and shaders/march/beam.frag.
#pragma once

#include "synthesis/assemble.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

// The scene's levels of beams. Adds to `shaders.files`.
void add_beams(const scene::Scene& scene, Shaders& shaders);

// Where rays begin and end: as the last level of beams says, or at the bounds if it is null. After
// the ray's own text.
void add_entrance(ShaderText& text, const BeamShader* beam);

} // namespace isomotion::synthesis
