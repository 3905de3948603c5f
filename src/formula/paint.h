// Colours of a surface, or numbers to colour it by, as expressions of what a picture knows at every
// place of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/field.h"

namespace isomotion::formula {

// What such an expression may name beside the surface's parameters and arrays; these go first.
// Positions and curvatures are in formula coordinates, the normal in world coordinates and towards
// F > 0; `evaluations` counts the field samples of the pixel's ray, `t` is in seconds.
//
// With n the unit normal towards F > 0, curvatures are those of div n: the sphere x^2+y^2+z^2-r^2
// has mean curvature +1/r, seen from either side.
inline const std::vector<std::string> paint_names{
    "x", "y", "z", "nx", "ny", "nz", "mean_curvature", "gaussian_curvature", "evaluations", "t"};

struct Paint {
    std::string text;          // as the user wrote it
    Graph graph;               // what is written and the field's value: what both have is one node
    std::vector<NodeId> roots; // a number, or a colour's three parts
    NodeId field = 0;          // F
    // Inputs: paint_names; then, of a colour, the parts of the material's own.
    Program value;
    std::optional<Program> hessian; // of the field, if the expression names a curvature

    bool uses(std::string_view name) const; // one of paint_names
};

// `surface` is the vocabulary that `field` was made with. Any field of an array may be named: those
// that F leaves out become part of its packing by with_elements_of(). Throws ParseError.
Paint make_paint(std::string_view text, const Vocabulary& surface, const Field& field);

// Without a text a part is that of the material's own colour.
using ColorTexts = std::array<std::optional<std::string>, 3>;
Paint make_color(const ColorTexts& texts, const Vocabulary& surface, const Field& field);

// The mean over an array's elements of three of its fields times `unit`, weighted by the size of
// their terms, or those of the least element: see element_weights.h. Where all are 0 it is the
// material's own colour. None if F does not go through the array.
std::optional<Paint> make_mean_color(const Vocabulary& surface, const Field& field, int array,
                                     const std::array<int, 3>& fields, double unit);

// float paint_value(vec3 p, vec3 n, vec2 curvature, float evaluations); reads `paint_time`.
std::string glsl_paint_value(const Paint& paint, const ArrayPacking& packing);
// vec3 color_value(vec3 p, vec3 n, vec2 curvature, float evaluations, vec3 own); `own` is the
// material's.
std::string glsl_color_value(const Paint& paint, const ArrayPacking& packing);

} // namespace isomotion::formula
