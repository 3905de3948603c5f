// Functions of a field of which beams tell by bits which elements matter: the set bits are what
// they go through.
#pragma once

#include <string>

#include "synthesis/field_text.h"

namespace isomotion::synthesis {

class ShaderText;

// The bits, behind the declarations of the field's storage.
void add_masks(ShaderText& text, const FieldStorage& storage);

// A generated function whose loops over the first array go through the bits that are set.
std::string over_masks(std::string glsl);

} // namespace isomotion::synthesis
