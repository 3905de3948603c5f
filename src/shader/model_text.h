// Models of a polynomial field in shaders: formula/glsl/glsl_model.h, shaders/models/.
#pragma once

#include <string>

#include "formula/field.h"
#include "formula/glsl/glsl_interval.h"
#include "scene/scene.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// Adds the type of a file of shaders/models/ by the name `type`, and F on it. Needs what
// add_enclosures() adds.
void add_models(ShaderText& text, const formula::Field& field, const std::string& type,
                const std::string& file, formula::Numbers numbers);

// Adds models over pieces of a ray, or of a block's beam, and how far from a piece's beginning a
// model stays away from 0.
void add_piece_models(ShaderText& text, const formula::Field& field, const std::string& file,
                      formula::Numbers numbers = formula::Numbers::floats);

// Adds inside_bounds(). Needs BOUNDS_ROUNDING, by which the bounds may be off.
void add_inside_bounds(ShaderText& text, const scene::OneSurface& one);

} // namespace isomotion::shader
