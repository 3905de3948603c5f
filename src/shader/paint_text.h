// The part of the shade pass that colours a surface by expressions of the place.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "shader/field_text.h"

namespace isomotion::shader {

// The paint of the surface: its map's number, or its colour at the place. Null if it has one
// colour, or one for each side.
const formula::Paint* painting(const scene::OneSurface& one);

// Whether the sums of a paint must run over all elements of the array with the grid. They must if
// they weigh elements differently from the field, since lists may then leave out some that matter.
bool sums_all_elements(const formula::Paint& paint, const FieldStorage& storage);

// The functions generated for paint and contours, which are added beside the field's.
std::vector<GeneratedFunction> painting_functions(const scene::OneSurface& one,
                                                  const FieldStorage& storage);

// Defines painted_color(Hit). Call it after those functions and shade/shading.glsl.
void add_painting(ShaderText& text, const scene::OneSurface& one);

} // namespace isomotion::shader
