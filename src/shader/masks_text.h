// Functions of a field whose beams mark the elements that matter by bits: loops run over the set
// bits.
#pragma once

#include <string>

#include "shader/field_text.h"

namespace isomotion::shader {

class ShaderText;

// Adds the bits, after the declarations of the field's storage.
void add_masks(ShaderText& text, const FieldStorage& storage);

// A generated function whose loops over the first array run over the set bits.
std::string over_masks(std::string glsl);

} // namespace isomotion::shader
