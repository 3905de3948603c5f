// The part of the shade pass that colours a surface by expressions of the place.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "synthesis/field_text.h"

namespace isomotion::synthesis {

// What colours the surface: its map's number, or its colour of the place; null where it has one
// colour, or one for each side.
const formula::Paint* painting(const scene::Scene& scene);

// Whether the sums of a paint go over all elements of the array with the grid: they weigh elements
// otherwise than the field, so lists may leave out some that matter.
bool sums_all_elements(const formula::Paint& paint, const FieldStorage& storage);

// What is generated for it and for contours, to be put beside the field's functions.
std::vector<GeneratedFunction> painting_functions(const scene::Scene& scene,
                                                  const FieldStorage& storage);

// Defines surface_color(Hit), after those functions and shade/shading.glsl.
void add_painting(ShaderText& text, const scene::Scene& scene);

} // namespace isomotion::synthesis
