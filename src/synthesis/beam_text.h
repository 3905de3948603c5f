// Shaders that find which part of their way rays need to march, block of pixels by block, and how
// rays learn of it: see render/beam_pass.h and shaders/march/beam.frag.
#pragma once

#include "synthesis/assemble.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

// The scene's levels of beams, the smallest of 8 pixels or of 1. Adds to `shaders.files`.
void add_beams(const scene::Scene& scene, Shaders& shaders, int finest);

// Where rays begin and end: as the last level of beams says, or at the bounds. After the ray's own
// text.
void add_entrance(ShaderText& text, const Shaders& shaders, bool by_beams);

// The same without lists: where rays begin and end, and no more.
void add_way(ShaderText& text, const Shaders& shaders, bool by_beams);

// Boxes around the beams of blocks of so many pixels, which lie in those of the last level.
void add_beam_of_block(ShaderText& text, const scene::Scene& scene, const Shaders& shaders,
                       int block);

// Of shadow rays, by the last level of beams from the lights: shaders/effects/light_beam.glsl.
void add_light_beams(ShaderText& text, const Shaders& shaders);

} // namespace isomotion::synthesis
