// Colours of a surface, or numbers that are mapped to colours, as expressions of the data that a
// picture has at each place of the surface.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/field.h"

namespace isomotion::formula {

// The names that such an expression may use besides the surface's parameters and arrays; they come
// first. Positions and curvatures are in formula coordinates. The normal is in world coordinates
// and points towards F > 0. `evaluations` counts the field samples of the pixel's ray; `t` is in
// seconds.
//
// With n the unit normal towards F > 0, curvatures are those of div n: the sphere x^2+y^2+z^2-r^2
// has mean curvature +1/r, seen from either side.
inline const std::vector<std::string> paint_names{
    "x", "y", "z", "nx", "ny", "nz", "mean_curvature", "gaussian_curvature", "evaluations", "t"};

struct Paint {
    std::string text;          // as the user wrote it
    Graph graph;               // the expressions and the field's value; common parts are one node
    std::vector<NodeId> roots; // a number, or a colour's three components
    NodeId field = 0;          // F
    // Inputs: paint_names; then, for a colour, the components of the material's own colour.
    Program value;
    std::optional<Program> hessian; // of the field, if the expression names a curvature

    bool uses(std::string_view name) const; // one of paint_names
};

// `surface` is the vocabulary that `field` was made with. The text may name any field of an array;
// with_elements_of() adds those that F leaves out to its packing. Throws ParseError.
Paint make_paint(std::string_view text, const Vocabulary& surface, const Field& field);

// A component without a text is that of the material's own colour.
using ColorTexts = std::array<std::optional<std::string>, 3>;
Paint make_color(const ColorTexts& texts, const Vocabulary& surface, const Field& field);

// The mean over an array's elements of three of their fields times `unit`, weighted by the size of
// the elements' terms, or the fields of the least element: see element_weights.h. Where all weights
// are 0 it is the material's own colour. None if F has no sum or least over the array.
std::optional<Paint> make_mean_color(const Vocabulary& surface, const Field& field, int array,
                                     const std::array<int, 3>& fields, double unit);

// float paint_value(vec3 p, vec3 n, vec2 curvature, float evaluations); reads `paint_time`.
std::string glsl_paint_value(const Paint& paint, const ArrayPacking& packing);
// vec3 color_value(vec3 p, vec3 n, vec2 curvature, float evaluations, vec3 own); `own` is the
// material's.
std::string glsl_color_value(const Paint& paint, const ArrayPacking& packing);

} // namespace isomotion::formula
