// Packs the fields of an array's elements for generated GLSL: in vec4 texels, each read once per
// element.
#pragma once

#include <set>
#include <string>

#include "formula/glsl/glsl.h"

namespace isomotion::formula {

// "a0_1.y" for the field in slot 5 of array 0.
std::string element_text(int array, int field, const ArrayPacking& packing);

// The texels of its array that the loop beginning at instruction `begin` uses, including inner
// loops over other arrays.
std::set<int> texels_read(const Program& program, std::size_t begin, const ArrayPacking& packing);

} // namespace isomotion::formula
