// The part of the shade pass that colours a surface by a number.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "synthesis/field_text.h"

namespace isomotion::synthesis {

// What is generated for it, to be put beside the field's functions.
std::vector<GeneratedFunction> paint_functions(const formula::Paint& paint,
                                               const formula::Field& field);

// Defines surface_color(Hit), after those functions and shade/shading.glsl.
void add_paint(ShaderText& text, const scene::Paint& paint);

} // namespace isomotion::synthesis
