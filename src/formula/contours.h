// A number of the place and its gradient, from which lines on a surface are drawn.
#pragma once

#include <string>
#include <string_view>

#include "formula/paint.h"

namespace isomotion::formula {

// The number and its derivatives by x, y and z, as the four roots of a paint. It may name x, y, z,
// t, the surface's parameters and arrays. Throws ParseError, also if it names another of
// paint_names: these have no derivatives here.
Paint make_contours(std::string_view text, const Vocabulary& surface, const Field& field);

// vec4 contour_value(vec3 p): the number and its gradient. The function reads `contour_time`.
std::string glsl_contour_value(const Paint& contours, const ArrayPacking& packing);

} // namespace isomotion::formula
