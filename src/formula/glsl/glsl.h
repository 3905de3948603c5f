// Writes a Program as GLSL.
//
// The text depends on the graph alone. Values come through `parameters[]` (vec4s in a uniform
// block). Arrays come through `vec4 array<k>_texel(int element, int texel)`, `array<k>_count` and
// `array<k>_least`, the value of least() without elements; the shader assembly declares these.
// Functions of shaders/math/ are called by their im_ names, see kernel_calls.h.
#pragma once

#include <string>
#include <vector>

#include "formula/graph/program.h"

namespace isomotion::formula {

// The layout of each array's fields: field `packed[array][slot]` is component slot%4 of texel
// slot/4 of its element.
using ArrayPacking = std::vector<std::vector<int>>;

struct GlslSignature {
    std::string head;                // "vec2 field_directional(vec3 p, vec3 d)"
    std::string result;              // "vec2": the type that takes the outputs in order
    std::vector<std::string> inputs; // the name of input k: "p.x", "p.y", ...
};

std::string emit_glsl(const Program& program, const GlslSignature& signature,
                      const ArrayPacking& packing);

// A float literal that reads back as the nearest float of `value`.
std::string glsl_literal(double value);
// A double literal that reads back as `value`, which is finite.
std::string glsl_double_literal(double value);
// The value of array<k>_least if all elements are present.
std::string glsl_least_of_none();
// "parameters[2].y" for index 9.
std::string glsl_parameter(int index);

} // namespace isomotion::formula
