// Lists of the elements that matter in beams, where shaders can write no lists, in GLSL ES: the
// beams of a level write bits, and a pass of its own copies the elements that they stand for into a
// texture, which smaller beams and rays read. See shaders/march/copies.glsl.
#pragma once

#include "scene/scene.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// Textures of 128 bits a texel that a level draws its lists' bits into; 0 without copies.
int masks_of_level(const FieldStorage& storage, const BeamLevel& level);

// Rows of the texture of copies that the lists of a row of blocks take, 16 columns a list.
int rows_of_copies(const PassPlan& plan, int level);

// Whether the lists of a tile fit into a texture of which WebGL2 promises so many rows: where
// elements have many fields they don't.
inline constexpr int most_rows_of_copies = 2048;
inline constexpr int tile_of_copies = 512; // pixels along the largest
bool copies_fit(const PassPlan& plan);

// The storage for shaders that go through copies: where there are none, the same.
FieldStorage through_copies(const FieldStorage& storage);
// The storage for the beams of a level and their lists: those of the first go through all elements.
FieldStorage storage_at_level(const FieldStorage& storage, int level);

// Adds what a level of beams writes its bits with.
void add_masks(ShaderText& text, const FieldStorage& storage);

// Adds what the beams of a later level read.
void add_copies_of_parent(ShaderText& text, const PassPlan& plan, int level);

// Adds what rays read.
void add_copies_of_ray(ShaderText& text, const PassPlan& plan);

// Copies the elements that the bits of a level tell.
Pass beam_copies_pass(const scene::OneSurface& one, const PassPlan& plan, int level);

} // namespace isomotion::shader
