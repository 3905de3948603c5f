// Shaders that find which part of their way rays need to march, block of pixels by block, and how
// rays learn of it: see render/beam_pass.h and shaders/march/beam.frag.
#pragma once

#include "scene/scene.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

// Texels from one of the squares of a level of beams to the next.
inline constexpr int beam_square = 64;

// Whether a scene's rays go by beams: as it says, or else with the method hermite where bounds of
// the field cost less than what they save.
bool uses_beams(const scene::Scene& scene);

// The levels of beams, the smallest of 8 pixels or of 1.
std::vector<BeamLevel> beam_levels(const FieldStorage& storage, int finest);
Pass beam_pass(const scene::Scene& scene, const Passes& passes, int level);

// Where rays begin and end: as the last level of beams says, or at the bounds. After the ray's own
// text.
void add_entrance(ShaderText& text, const Passes& passes, bool by_beams);

// The same without lists: where rays begin and end, and no more.
void add_way(ShaderText& text, const Passes& passes, bool by_beams);

// Adds boxes around the beams of blocks of so many pixels, which lie in those of the last level.
void add_beam_of_block(ShaderText& text, const scene::Scene& scene, const Passes& passes,
                       int block);

// Where shadow rays begin, by the last level of beams from the lights:
// shaders/effects/light_beam.glsl.
void add_light_beams(ShaderText& text, const Passes& passes);

} // namespace isomotion::synthesis
