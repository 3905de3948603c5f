// Shaders that find the part of rays that needs marching, for blocks of pixels, and pass it on to
// the rays: see render/beam_pass.h and shaders/march/beam_by_intervals.glsl.
#pragma once

#include "scene/scene.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// Texels from one square of a level of beams to the next.
inline constexpr int beam_square = 64;

// Whether a scene's rays use beams: as the scene states, otherwise with the method hermite if
// bounds of the field cost less than they save. In compute shaders assemble() asks for more.
bool uses_beams(const scene::OneSurface& one);

// Adds where the results of a level of beams lie.
void define_blocks(ShaderText& text, const BeamLevel& beam);

// Whether beams by models can tell where the first roots of a scene's rays are: those of a
// polynomial of low degree without sections, by the method hermite.
bool can_settle_blocks(const scene::OneSurface& one, int finest);

// Whether the last level does.
inline bool settles_blocks(const PassPlan& plan) {
    return !plan.beams.empty() && plan.beams.back().by_models;
}

// The levels of beams; the smallest have 8 pixels or 1.
std::vector<BeamLevel> beam_levels(const FieldStorage& storage, int finest);
// The one that settles blocks, in those of intervals where there are some.
BeamLevel level_by_models(int finest);
Pass beam_pass(const scene::OneSurface& one, const PassPlan& plan, int level);

// Adds the code that determines where rays begin and end: by the last level of beams, or at the
// bounds. Call it after the ray's own text.
void add_entrance(ShaderText& text, const PassPlan& plan, bool by_beams);

// The same without lists.
void add_way(ShaderText& text, const PassPlan& plan, bool by_beams);

// Whether blocks of `block` pixels lie in the beams of the last level.
bool lies_in_beams(const PassPlan& plan, int block);

// Defines where those that lie in beams of this level find them.
void define_parent(ShaderText& text, const BeamLevel& parent);

// Adds boxes around the beams of blocks of `block` pixels, which lie in those of the last level.
void add_beam_of_block(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan,
                       int block);

// Adds the code that determines where shadow rays begin, by the last level of beams from the
// lights: shaders/effects/light_beam.glsl.
void add_light_beams(ShaderText& text, const PassPlan& plan);

} // namespace isomotion::shader
